# gibench_stop(TEXT ...): ends the configuration. CMake folds its messages over several lines and adds more below; run.sh and
# test.sh print the text of this file as one last line.
set(GIBENCH_STOP_FILE ${CMAKE_BINARY_DIR}/stopped.txt)
file(REMOVE ${GIBENCH_STOP_FILE})
function(gibench_stop)
  string(JOIN "" text ${ARGN})
  file(WRITE ${GIBENCH_STOP_FILE} "${text}\n")
  message(FATAL_ERROR "${text}")
endfunction()
