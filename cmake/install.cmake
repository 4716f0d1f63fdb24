# What the program reads at run time lies in share/gibench, found from the program's own place: ../share/gibench. The
# build folder has the same layout as the installed tree, with links to the sources.
include(GNUInstallDirs)
# Whatever names no component is of the program; the others are plots (packages of npm) and development (package.cmake).
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
# Where the program looks, and so not to be set: bin/gibench, lib/gibench/, share/gibench/.
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)

set(GIBENCH_DATA_FOLDER ${CMAKE_BINARY_DIR}/share/gibench)
set(report_files render.mjs package.json package-lock.json)

file(MAKE_DIRECTORY ${GIBENCH_DATA_FOLDER}/reports)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/scenes ${GIBENCH_DATA_FOLDER}/scenes COPY_ON_ERROR SYMBOLIC)
# `gibench help` says where the pages lie.
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/share/doc/gibench)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/docs ${CMAKE_BINARY_DIR}/share/doc/gibench/docs COPY_ON_ERROR SYMBOLIC)
foreach(folder page plots)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/reports/${folder} ${GIBENCH_DATA_FOLDER}/reports/${folder} COPY_ON_ERROR SYMBOLIC)
endforeach()
# Copies: Node.js looks for the packages beside the file that a link points to, and `npm ci` puts them beside these.
foreach(file ${report_files})
  configure_file(${PROJECT_SOURCE_DIR}/reports/${file} ${GIBENCH_DATA_FOLDER}/reports/${file} COPYONLY)
endforeach()

set(data share/gibench)
install(DIRECTORY scenes DESTINATION ${data} FILES_MATCHING PATTERN "*.json" PATTERN "*.md"
        PATTERN "*.replicas" PATTERN "generators" EXCLUDE)
install(DIRECTORY ${GIBENCH_DATA_FOLDER}/generated_scenes DESTINATION ${data} OPTIONAL)
install(DIRECTORY reports/page reports/plots DESTINATION ${data}/reports)
list(TRANSFORM report_files PREPEND reports/)
install(FILES ${report_files} DESTINATION ${data}/reports)
install(DIRECTORY ${GIBENCH_DATA_FOLDER}/reports/node_modules DESTINATION ${data}/reports COMPONENT plots OPTIONAL
        PATTERN "playwright-core" EXCLUDE)  # only the tests use a browser
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN "Doxyfile" EXCLUDE)
install(FILES README.md CHANGELOG.md CITATION.cff LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
