# Runs tiny_dry.prm of the folder SOURCE with PROGRAM in FOLDER under the load that a
# run in blood, with results in IN_BLOOD, has recorded. Asserts that after 0.44 ms the
# leaflets sweep volume as fast as in blood, to 5 %.
cmake_minimum_required(VERSION 3.19)

file(REMOVE_RECURSE ${FOLDER})
file(COPY ${SOURCE}/pressure.csv ${IN_BLOOD}/surface_load.csv DESTINATION ${FOLDER})
file(READ ${SOURCE}/tiny_dry.prm parameters)
file(WRITE ${FOLDER}/recorded.prm "${parameters}
subsection Time
  set End time = 4.4e-4
end
subsection Output
  set Interval = 1.1e-4
end
subsection Structure
  set Load         = recorded
  set Load file    = surface_load.csv
  set Mass damping = 0
  set Added mass   = 0
end
")
execute_process(COMMAND ${PROGRAM} recorded.prm WORKING_DIRECTORY ${FOLDER}
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "Exit code ${code}:\n${output}")
endif()

execute_process(COMMAND awk -F, "
  FNR == 1 { for (i = 1; i <= NF; ++i) if ($i == \"swept_flow_mL_per_s\") column = i; ++file }
  FNR == 6 { flow[file] = $column; time[file] = $1 }
  END { print \"at\", time[1], time[2], \"s:\", flow[1], flow[2], \"mL/s\"
    error = flow[2] / flow[1] - 1
    exit !(time[1] == time[2] && flow[1] > 100 && error < 0.05 && error > -0.05) }"
  ${IN_BLOOD}/statistics.csv ${FOLDER}/results/statistics.csv
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
message("${output}")
if(NOT code EQUAL 0)
  message(FATAL_ERROR "The leaflets do not follow those in blood.")
endif()
