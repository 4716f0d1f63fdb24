# How the project's own targets are made: one library a folder, one test program a test folder.

# Projects that use the installed libraries choose their own warnings, but not what decides the code: headers hold lanes of the
# processor's vectors.
add_library(gibench_options INTERFACE)
target_include_directories(gibench_options INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                           $<INSTALL_INTERFACE:include/gibench>)
target_compile_features(gibench_options INTERFACE cxx_std_20)
set(warnings -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion ${GIBENCH_FALSE_WARNINGS}
    $<$<BOOL:${GIBENCH_WARNINGS_AS_ERRORS}>:-Werror>)
target_compile_options(gibench_options INTERFACE "$<BUILD_INTERFACE:${warnings}>"
                       $<$<BOOL:${GIBENCH_ARCHITECTURE}>:-march=${GIBENCH_ARCHITECTURE}>
                       # Fused multiply-adds are contracted the same way in every build of one machine only where
                       # the compiler is told not to choose: same seed, same bits.
                       -ffp-contract=off)
# A default must not hide a kind that a switch forgets.
target_compile_options(gibench_options INTERFACE $<BUILD_INTERFACE:-Wswitch-enum>)
target_compile_definitions(gibench_options INTERFACE $<$<BOOL:${GIBENCH_STD_THREADS}>:GIBENCH_STD_THREADS>)
target_link_libraries(gibench_options INTERFACE Threads::Threads fmt::fmt nlohmann_json::nlohmann_json glm::glm)
gibench_install_library(gibench_options options)

# gibench_cool(TARGET): code without hot loops (verbs, loaders, tests) compiles in two thirds of the time this way.
function(gibench_cool TARGET)
  target_compile_options(${TARGET} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# gibench_together(TARGET): several files at a time are compiled as one, which shares what they instantiate of headers. What has hot
# loops is not: what the compiler inlines there must not depend on a file's neighbours.
function(gibench_together TARGET)
  if(GIBENCH_TOGETHER)
    set_target_properties(${TARGET} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  endif()
endfunction()

# gibench_precompile(KIND ...): headers of others that most files include, parsed once for all targets of a kind: the
# compiler takes them only where its options are the same, so hot code, cool code and tests have each their own.
function(gibench_precompile KIND)
  set(source ${CMAKE_BINARY_DIR}/precompiled.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "int main() {}\n")
  if(KIND STREQUAL test)
    add_executable(gibench_precompiled_${KIND} ${source})  # as programs are: -fPIE
    target_link_libraries(gibench_precompiled_${KIND} PRIVATE GTest::gmock GTest::gtest)
  else()
    add_library(gibench_precompiled_${KIND} OBJECT ${source})
  endif()
  target_link_libraries(gibench_precompiled_${KIND} PRIVATE gibench_options)
  if(NOT KIND STREQUAL hot)
    gibench_cool(gibench_precompiled_${KIND})
  endif()
  target_precompile_headers(gibench_precompiled_${KIND} PRIVATE ${ARGN})
endfunction()

# gibench_use_precompiled(TARGET KIND)
function(gibench_use_precompiled TARGET KIND)
  if(GIBENCH_PRECOMPILED_HEADERS)
    target_precompile_headers(${TARGET} REUSE_FROM gibench_precompiled_${KIND})
    # GCC 12 warns of std::string's own inlined code when it comes from a precompiled header; the sanitizers' builds,
    # which use none, keep these warnings.
    target_compile_options(${TARGET} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds -Wno-restrict
                           -Wno-stringop-overread -Wno-stringop-overflow>)
  endif()
endfunction()

if(GIBENCH_PRECOMPILED_HEADERS)
  set(usual <algorithm> <array> <atomic> <cmath> <condition_variable> <cstdint> <filesystem> <functional> <limits> <map>
      <memory> <mutex> <numeric> <optional> <set> <span> <string> <utility> <variant> <vector> <fmt/format.h> <glm/glm.hpp>)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND usual <immintrin.h>)
  endif()
  gibench_precompile(hot ${usual})
  gibench_precompile(cool ${usual} <fstream> <nlohmann/json.hpp>)
  gibench_precompile(program ${usual} <fstream> <nlohmann/json.hpp> <CLI/CLI.hpp>)
  if(GIBENCH_TESTS)
    gibench_precompile(test ${usual} <fstream> <nlohmann/json.hpp> <gmock/gmock.h> <gtest/gtest.h>)
  endif()
endif()

# gibench_library(NAME [COOL] LIBRARIES ...): a static library gibench_NAME of every .cpp file of this folder, installed as
# gibench::NAME.
function(gibench_library NAME)
  cmake_parse_arguments(ARG "COOL" "" "LIBRARIES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(sources)
    add_library(gibench_${NAME} STATIC ${sources})
    target_link_libraries(gibench_${NAME} PUBLIC gibench_options ${ARG_LIBRARIES})
    if(ARG_COOL)
      gibench_cool(gibench_${NAME})
      gibench_together(gibench_${NAME})
      gibench_use_precompiled(gibench_${NAME} cool)
    else()
      gibench_use_precompiled(gibench_${NAME} hot)
    endif()
  else()  # headers only
    add_library(gibench_${NAME} INTERFACE)
    target_link_libraries(gibench_${NAME} INTERFACE gibench_options ${ARG_LIBRARIES})
  endif()
  gibench_install_library(gibench_${NAME} ${NAME})
endfunction()

# gibench_test(NAME [SLOW] LIBRARIES ... [EXCEPT FILE...]): a test program test_NAME of every .cpp file of this folder but
# some; its cases are CTest tests. GIBENCH_TEST_DATA is this folder. SLOW ones are labelled `long` and started first, so that no
# core idles at the end.
function(gibench_test NAME)
  cmake_parse_arguments(ARG "SLOW" "" "LIBRARIES;EXCEPT" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(REMOVE_ITEM sources ${ARG_EXCEPT})
  add_executable(test_${NAME} ${sources})
  target_link_libraries(test_${NAME} PRIVATE gibench_options ${ARG_LIBRARIES} GTest::gmock GTest::gtest GTest::gtest_main)
  target_compile_definitions(test_${NAME} PRIVATE GIBENCH_TEST_DATA="${CMAKE_CURRENT_SOURCE_DIR}"
                             GIBENCH_SOURCE_DIR="${PROJECT_SOURCE_DIR}" GIBENCH_PROGRAM="${CMAKE_BINARY_DIR}/bin/gibench")
  gibench_cool(test_${NAME})
  gibench_together(test_${NAME})
  gibench_use_precompiled(test_${NAME} test)
  include(GoogleTest)
  set(order "")  # without a cost CTest goes by what it measured the last time
  if(ARG_SLOW)
    set(order COST 100 LABELS long)
  endif()
  gtest_discover_tests(test_${NAME} DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 600 ${order})
endfunction()

# Adds every subfolder that has a CMakeLists.txt.
function(gibench_add_subfolders)
  file(GLOB folders CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*/CMakeLists.txt)
  foreach(file ${folders})
    get_filename_component(folder ${file} DIRECTORY)
    add_subdirectory(${folder})
  endforeach()
endfunction()
