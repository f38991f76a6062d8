# Runs one step of the coarse valve COARSE in a fresh FOLDER three times: into
# nothing, into the results of that (which must be refused and leave them alone),
# and over them. The coupling points are sparse: the warning must come before the
# run starts.
cmake_minimum_required(VERSION 3.18)
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
file(READ ${COARSE} coarse)

function(run overwrite expected_code)
  file(WRITE ${FOLDER}/case.prm "${coarse}"
    "subsection Time\n  set End time = 1e-6\nend\n"
    "subsection Coupling\n  set Point spacing = 1\nend\n"
    "subsection Output\n  set Folder = results\n  set Overwrite = ${overwrite}\nend\n")
  execute_process(COMMAND ${PROGRAM} case.prm WORKING_DIRECTORY ${FOLDER}
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL expected_code)
    message(FATAL_ERROR "Exit code ${code} instead of ${expected_code}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

run(false 0)
file(READ ${FOLDER}/results/coapt.log log)
if(NOT log MATCHES "warning: Coupling: Point spacing is 1\\.0[^\n]*leak.*\n +0\\.00 / ")
  message(FATAL_ERROR "No warning before the run:\n${log}")
endif()
file(READ ${FOLDER}/results/summary.json summary)
if(NOT summary MATCHES "\"warnings\": [^\n]*Point spacing is 1\\.0")
  message(FATAL_ERROR "No warning in the summary:\n${summary}")
endif()

run(false 2)
if(NOT output MATCHES "^coapt: output folder 'results' holds another run[^\n]*\n$")
  message(FATAL_ERROR "Another message than expected:\n${output}")
endif()
file(READ ${FOLDER}/results/coapt.log now)
if(NOT now STREQUAL log)
  message(FATAL_ERROR "A refused run has changed the log:\n${now}")
endif()

file(WRITE ${FOLDER}/results/fields/fluid_00077.pvtu "of an earlier run")
file(WRITE ${FOLDER}/results/notes.txt "of the user")
file(WRITE ${FOLDER}/results/run_7/statistics.csv "of an earlier study")
file(WRITE ${FOLDER}/results/run_8/statistics.csv "of an earlier study")
file(WRITE ${FOLDER}/results/run_8/notes.txt "of the user")
file(WRITE ${FOLDER}/results/profile_3.csv "of an earlier run")
file(WRITE ${FOLDER}/results/surface_load.csv "of an earlier run")
run(true 0)
foreach(file fields/fluid_00077.pvtu run_7 run_8/statistics.csv profile_3.csv surface_load.csv)
  if(EXISTS ${FOLDER}/results/${file})
    message(FATAL_ERROR "${file} of the earlier run is still there.")
  endif()
endforeach()
if(NOT EXISTS ${FOLDER}/results/run_8/notes.txt)
  message(FATAL_ERROR "A file in a folder of a study that is no result has been removed.")
endif()
if(NOT EXISTS ${FOLDER}/results/notes.txt)
  message(FATAL_ERROR "A file that is no result has been removed.")
endif()
