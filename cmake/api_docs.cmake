# The target gibench_api_docs, where Doxygen is installed: API documentation in the build folder, api/index.html.
find_program(GIBENCH_DOXYGEN doxygen)
mark_as_advanced(GIBENCH_DOXYGEN)
if(GIBENCH_DOXYGEN)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS docs/Doxyfile)
  file(READ docs/Doxyfile settings)
  file(CONFIGURE OUTPUT Doxyfile @ONLY CONTENT [[@settings@
PROJECT_NUMBER   = @PROJECT_VERSION@
OUTPUT_DIRECTORY = "@CMAKE_BINARY_DIR@"
]])
  add_custom_target(gibench_api_docs COMMAND ${GIBENCH_DOXYGEN} ${CMAKE_BINARY_DIR}/Doxyfile WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
                    COMMENT "API documentation: ${CMAKE_BINARY_DIR}/api/index.html" VERBATIM)
endif()
