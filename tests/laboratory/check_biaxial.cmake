# Runs the parameter file CASE of the task biaxial with PROGRAM in FOLDER, with its
# stretches and with tensions. Asserts that the tables have a row for each state of the
# protocol, and that both methods are within 1e-4 of the homogeneous state, as reported and
# in the tables.
cmake_minimum_required(VERSION 3.18)

# check(NAME PROTOCOL ADDED METHOD...): with ADDED at the end of the case, the tables
# of these methods
function(check name protocol added)
  set(folder ${FOLDER}/${name})
  file(REMOVE_RECURSE ${folder})
  file(READ ${CASE} case)
  file(WRITE ${folder}/biaxial.prm "${case}${added}")
  execute_process(COMMAND ${PROGRAM} biaxial.prm WORKING_DIRECTORY ${folder}
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${name}: exit code ${code}\n${output}")
  endif()

  file(STRINGS ${SOURCE}/parameter-files/tables/${protocol} states REGEX "^[0-9]")
  list(LENGTH states n_states)
  foreach(method ${ARGN})
    execute_process(COMMAND awk -F, -v states=${n_states}
      -f ${CMAKE_CURRENT_LIST_DIR}/compare_stresses.awk ${folder}/output/biaxial/${method}.csv
      RESULT_VARIABLE code OUTPUT_VARIABLE difference ERROR_VARIABLE difference)
    if(NOT code EQUAL 0)
      message(FATAL_ERROR "${name}, ${method}: ${difference}")
    endif()
    message("${name}, ${method}: ${difference} of the largest stress")
  endforeach()
  string(REGEX MATCHALL "farthest from the homogeneous state [^ ]+ of it" lines "${output}")
  list(LENGTH lines n_lines)
  list(LENGTH ARGN n_methods)
  if(NOT n_lines EQUAL n_methods)
    message(FATAL_ERROR "${name}: ${n_lines} methods are reported\n${output}")
  endif()
endfunction()

check(stretches biaxial_protocol.csv "" quasi_static dynamic)
check(tensions biaxial_tensions.csv
  "subsection Biaxial\n  set Protocol = tables/biaxial_tensions.csv\n  set Methods = quasi-static\nend\n"
  quasi_static)
