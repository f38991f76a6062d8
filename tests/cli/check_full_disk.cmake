# Runs the parameter file CASE where no file may become larger than 60 kB, which
# fails like a full disk. The run must end with exit code 1 and say which file.
cmake_minimum_required(VERSION 3.18)
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
file(READ ${CASE} case)
file(WRITE ${FOLDER}/case.prm "${case}"
  "subsection Time\n  set End time = 5e-4\nend\n"
  "subsection Output\n  set Folder = results\n  set Interval = 1e-4\n"
  "  set Fields interval = 1e-4\nend\n")
execute_process(
  COMMAND ${MPIEXEC} -np ${RANKS} bash -c "trap '' XFSZ; ulimit -f 60; exec ${PROGRAM} case.prm"
  WORKING_DIRECTORY ${FOLDER}
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE error)
if(NOT code EQUAL 1)
  message(FATAL_ERROR "Exit code ${code} instead of 1:\n${output}\n${error}")
endif()
if(NOT error MATCHES "coapt: results/(run_1/)?fields/[a-z_0-9.]*vtu: writing failed; is the disk full.\n")
  message(FATAL_ERROR "Another message than expected:\n${error}")
endif()
