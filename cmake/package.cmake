# The installed package: find_package(gibench) in another project gives the libraries as gibench::NAME, among them
#   gibench::method    all that a method needs: common/, without readers of files and pictures
#   gibench::program   the whole program but main(): see gibench_add_program() in package/gibench_add_program.cmake
#   gibench::contract  the checks that every method must pass, where the tests were built
# It can be moved with the tree.
include(CMakePackageConfigHelpers)

set(GIBENCH_PACKAGE_FOLDER lib/cmake/gibench)

# gibench_install_library(TARGET NAME): as gibench::NAME.
function(gibench_install_library TARGET NAME)
  set_target_properties(${TARGET} PROPERTIES EXPORT_NAME ${NAME})
  install(TARGETS ${TARGET} EXPORT gibench ARCHIVE DESTINATION lib/gibench COMPONENT development)
endfunction()

# gibench_install_contract(TARGET): in a set of its own, for a tree without tests has none.
function(gibench_install_contract TARGET)
  set_target_properties(${TARGET} PROPERTIES EXPORT_NAME contract)
  install(TARGETS ${TARGET} EXPORT gibench_contract ARCHIVE DESTINATION lib/gibench COMPONENT development OPTIONAL)
  install(EXPORT gibench_contract NAMESPACE gibench:: FILE gibenchContract.cmake DESTINATION ${GIBENCH_PACKAGE_FOLDER} COMPONENT development)
  install(FILES ${CMAKE_CURRENT_SOURCE_DIR}/contract.h DESTINATION include/gibench/tests/contract COMPONENT development)
endfunction()

install(EXPORT gibench NAMESPACE gibench:: FILE gibenchTargets.cmake DESTINATION ${GIBENCH_PACKAGE_FOLDER} COMPONENT development)
configure_file(cmake/package/gibenchConfig.cmake.in ${CMAKE_BINARY_DIR}/gibenchConfig.cmake @ONLY)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/gibenchConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/gibenchConfig.cmake ${CMAKE_BINARY_DIR}/gibenchConfigVersion.cmake cmake/FindMETIS.cmake
              cmake/package/gibench_add_program.cmake
        DESTINATION ${GIBENCH_PACKAGE_FOLDER} COMPONENT development)

# Headers keep their paths: #include "common/method/method.h". Not those that see other projects' headers behind an interface.
install(DIRECTORY common DESTINATION include/gibench COMPONENT development FILES_MATCHING PATTERN "*.h"
        PATTERN embree EXCLUDE PATTERN plugin EXCLUDE PATTERN assimp EXCLUDE PATTERN native EXCLUDE)
install(FILES bench/app/program.h DESTINATION include/gibench/bench/app COMPONENT development)
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development)
