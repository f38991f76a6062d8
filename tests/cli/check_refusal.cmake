# Checks and runs the parameter file PARAMETERS on RANKS (default 1) ranks in a
# fresh FOLDER that holds the results of another run, which may be overwritten
# unless OVERWRITE is false. Asserts exit code 2, one line and no more, which
# matches REGEX, and that nothing was touched.
cmake_minimum_required(VERSION 3.18)
if(NOT DEFINED OVERWRITE)
  set(OVERWRITE true)
endif()
set(launch "")
if(DEFINED RANKS)
  set(launch ${MPIEXEC} -n ${RANKS})
endif()

# the case, its tables, and a run that ends at once should it be accepted
file(REMOVE_RECURSE ${FOLDER})
get_filename_component(source ${PARAMETERS} DIRECTORY)
file(GLOB tables ${source}/*.csv ${source}/*.msh)
file(COPY ${tables} DESTINATION ${FOLDER})
file(READ ${PARAMETERS} parameters)
if(NOT parameters MATCHES "End ti|Task = (fit|biaxial)")
  string(APPEND parameters "subsection Time\n  set End time = 1e-6\nend\n")
endif()
file(WRITE ${FOLDER}/case.prm "${parameters}subsection Output\n"
  "  set Folder = results\n  set Overwrite = ${OVERWRITE}\nend\n")
file(WRITE ${FOLDER}/results/statistics.csv "earlier results\n")

foreach(option --check "")
  execute_process(COMMAND ${launch} ${PROGRAM} ${option} case.prm
    WORKING_DIRECTORY ${FOLDER}
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REPLACE ";" "," lines "${output}")
  string(REPLACE "\n" ";" lines "${lines}")
  list(FILTER lines EXCLUDE REGEX "^ *$")
  if(DEFINED RANKS) # mpirun adds paragraphs of its own
    list(FILTER lines INCLUDE REGEX "coapt: |MPI_ABORT|what\\(\\)")
  endif()
  list(LENGTH lines n_lines)

  if(NOT code EQUAL 2)
    message(FATAL_ERROR "'${option}' exit code ${code} instead of 2:\n${output}")
  endif()
  if(NOT n_lines EQUAL 1)
    message(FATAL_ERROR "'${option}' ${n_lines} lines instead of one:\n${output}")
  endif()
  if(NOT lines MATCHES "^coapt: " OR NOT lines MATCHES "${REGEX}")
    message(FATAL_ERROR "'${option}' nothing matches '${REGEX}':\n${output}")
  endif()

  file(GLOB_RECURSE results RELATIVE ${FOLDER}/results ${FOLDER}/results/*)
  file(READ ${FOLDER}/results/statistics.csv content)
  if(NOT results STREQUAL "statistics.csv" OR NOT content STREQUAL "earlier results\n")
    message(FATAL_ERROR "'${option}' touched the output folder: ${results}")
  endif()
endforeach()
