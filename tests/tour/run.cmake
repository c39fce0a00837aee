# Runs PROGRAM, with ARGUMENT where that is not empty, and fails unless a block of PAGE shows just
# what it prints.
#   cmake -DPROGRAM=... -DARGUMENT=... -DPAGE=... -P run.cmake

execute_process(COMMAND "${PROGRAM}" ${ARGUMENT}
  OUTPUT_VARIABLE printed RESULT_VARIABLE code COMMAND_ECHO NONE)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "ended with ${code}:\n${printed}")
endif()
file(READ "${PAGE}" page)
string(FIND "${page}" "```\n${printed}```\n" place)
if(place EQUAL -1)
  message(FATAL_ERROR "${PAGE} does not show what was printed:\n${printed}")
endif()
