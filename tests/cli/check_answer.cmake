# Calls PROGRAM with ARGUMENTS; asserts the exit code CODE and that what it
# prints matches REGEX, and that there are FILES afterwards that were not before.
cmake_minimum_required(VERSION 3.18)
foreach(file ${FILES})
  file(REMOVE ${file})
endforeach()
execute_process(COMMAND ${PROGRAM} ${ARGUMENTS}
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT code STREQUAL CODE)
  message(FATAL_ERROR "Exit code ${code} instead of ${CODE}:\n${output}")
endif()
if(NOT output MATCHES "${REGEX}")
  message(FATAL_ERROR "Nothing matches '${REGEX}':\n${output}")
endif()
foreach(file ${FILES})
  if(NOT EXISTS ${file})
    message(FATAL_ERROR "${file} is missing:\n${output}")
  endif()
endforeach()
