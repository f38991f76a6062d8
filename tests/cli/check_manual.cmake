# Asserts that doc/parameters.md is what PROGRAM has to say today.
cmake_minimum_required(VERSION 3.18)
execute_process(COMMAND sh -c "'${PROGRAM}' --write-defaults valve && '${PROGRAM}' --write-defaults flow && '${PROGRAM}' --write-defaults immersed && '${PROGRAM}' --write-defaults biaxial && '${PROGRAM}' --write-defaults fit"
  COMMAND awk -f ${SOURCE}/tools/parameters.awk
  RESULT_VARIABLE code OUTPUT_VARIABLE now)
file(READ ${SOURCE}/doc/parameters.md manual)
if(NOT code EQUAL 0 OR NOT now STREQUAL manual)
  message(FATAL_ERROR "doc/parameters.md is stale: run tools/write_parameters.sh")
endif()
