# What scripts share that run the program PROGRAM, by MPIEXEC, and look at what it leaves.

# require(TEXT CONDITION...): ends the test with this text unless the condition holds.
function(require condition_text)
  if(NOT (${ARGN}))
    message(FATAL_ERROR "${condition_text}")
  endif()
endfunction()

# run_program(CODE RANKS FOLDER FILE): runs FILE on so many ranks in FOLDER, which must end
# with this exit code; sets output to all that it says.
function(run_program expected ranks folder file)
  execute_process(COMMAND ${MPIEXEC} -n ${ranks} ${PROGRAM} ${file}
    WORKING_DIRECTORY ${folder}
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  require("Exit code ${code} instead of ${expected} on ${ranks} ranks:\n${output}"
    code EQUAL ${expected})
  set(output "${output}" PARENT_SCOPE)
endfunction()
