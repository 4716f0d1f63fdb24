# gibench_add_program(NAME SOURCE...): the program with another main(), which calls gibench::run_program() with methods of its own.
# It is bin/NAME of the build folder. Scenes, plugin and report files are found from there as in an installed tree: the folders
# are links to those of the package. `cmake --install BUILD --prefix PREFIX`, with the prefix of gibench, puts it beside gibench.
function(gibench_add_program NAME)
  cmake_path(SET prefix NORMALIZE "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../../..")
  add_executable(${NAME} ${ARGN})
  target_link_libraries(${NAME} PRIVATE gibench::program)
  set_target_properties(${NAME} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin" INSTALL_RPATH_USE_LINK_PATH ON)
  foreach(parent lib share)
    file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/${parent}")
    file(CREATE_LINK "${prefix}/${parent}/gibench" "${CMAKE_BINARY_DIR}/${parent}/gibench" SYMBOLIC)
  endforeach()
  install(TARGETS ${NAME} RUNTIME DESTINATION bin)
endfunction()
