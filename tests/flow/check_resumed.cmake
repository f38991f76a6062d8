# Interrupts the file CASE, with PROGRAM on RANKS ranks in FOLDER, at the time AT (s) of
# END, in its last run, and lets it go on from its checkpoint. Asserts that all columns
# of the statistics are, to 1e-9, the same as in one go, and that the table is the same
# to 1e-7 but for the wall time; and that another number of ranks is refused.
cmake_minimum_required(VERSION 3.19)
include(${CMAKE_CURRENT_LIST_DIR}/../run_program.cmake)

# run(EXPECTED_CODE RANKS OUTPUT_FOLDER TEXT): with this text added to the file.
function(run expected ranks folder text)
  file(READ ${CASE} parameters)
  file(WRITE ${FOLDER}/case.prm "${parameters}${CHANGES}\n${text}
subsection Output
  set Folder = ${folder}
  set Overwrite = true
end
subsection Flow
  set Figures from = 0
end
")
  run_program(${expected} ${ranks} ${FOLDER} case.prm)
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${FOLDER})
set(end "subsection Time\nset End time = ${END}\nend")
run(0 ${RANKS} whole "${end}")
file(STRINGS ${FOLDER}/whole/study.csv lines)
list(LENGTH lines last)
math(EXPR last "${last} - 1")

run(0 ${RANKS} parts "subsection Time\nset End time = ${AT}\nend
subsection Output\nset Checkpoint interval = 1e-9\nend")
if(last GREATER 1)
  # the runs before the last one as they were in one go
  list(SUBLIST lines 0 ${last} lines)
  string(REPLACE ";" "\n" lines "${lines}")
  file(WRITE ${FOLDER}/parts/study.csv "${lines}\n")
else()
  file(REMOVE ${FOLDER}/parts/study.csv)
endif()

# A study goes on with the same runs, whose end belongs to them.
set(resume "${end}\nsubsection Output\nset Resume = true\nend")
run(2 ${RANKS} parts "${resume}")
if(NOT output MATCHES "a study goes on with the same runs")
  message(FATAL_ERROR "Another end is not refused as such:\n${output}")
endif()
file(READ ${FOLDER}/parts/plan.txt plan)
string(REPLACE "to ${AT} s" "to ${END} s" plan "${plan}")
file(WRITE ${FOLDER}/parts/plan.txt "${plan}")
math(EXPR others "3 - ${RANKS}")
run(2 ${others} parts "${resume}")
if(NOT output MATCHES "not of ${others} process")
  message(FATAL_ERROR "${others} ranks are not refused as such:\n${output}")
endif()
run(0 ${RANKS} parts "${resume}")
if(NOT output MATCHES "goes on from")
  message(FATAL_ERROR "No word of the checkpoint:\n${output}")
endif()
execute_process(COMMAND awk -F, -f ${COMPARE}
  ${FOLDER}/whole/run_${last}/statistics.csv ${FOLDER}/parts/run_${last}/statistics.csv
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "The statistics differ:\n${output}")
endif()
# Orders follow from errors that have been read with nine digits.
execute_process(COMMAND awk -F, "
  FNR == 1 { ++file; columns = split($0, name, \",\"); next }
  file == 1 { for (i = 1; i <= columns; ++i) value[FNR, i] = $i; rows = FNR; next }
  { for (i = 1; i <= columns; ++i)
      if (name[i] != \"wall_s\" && ($i - value[FNR, i])^2 > 1e-14 * $i^2) {
        print name[i] \": \" value[FNR, i] \" and \" $i
        failed = 1
      }
    last = FNR }
  END { exit failed || last != rows }"
  ${FOLDER}/whole/study.csv ${FOLDER}/parts/study.csv
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "The tables differ:\n${output}")
endif()
