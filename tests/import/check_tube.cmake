# Runs tube.prm of the folder SOURCE with PROGRAM on 1 and 2 ranks, in FOLDER. Asserts
# that the results are there, that energy is balanced, with the work of the motion
# in it, and that the statistics are the same on both.
cmake_minimum_required(VERSION 3.19)
include(${CMAKE_CURRENT_LIST_DIR}/../run_program.cmake)

foreach(ranks 1 2)
  set(folder ${FOLDER}/${ranks})
  file(REMOVE_RECURSE ${folder})
  file(GLOB files ${SOURCE}/*.csv ${SOURCE}/tube.*)
  file(COPY ${files} DESTINATION ${folder})
  run_program(0 ${ranks} ${folder} tube.prm)
  foreach(name statistics.csv fields/leaflet_00001.vtu fields/chordae_00001.vtu)
    require("${name} is missing" EXISTS ${folder}/results/${name})
  endforeach()
  file(READ ${folder}/results/summary.json text)
  string(JSON error GET "${text}" energy_error_relative)
  require("The energy error is ${error}" error LESS 0.02)
  string(JSON force GET "${text}" chordae_peak_N anterior_primary)
  require("The chordae do not pull" force GREATER 0)
endforeach()

execute_process(COMMAND awk -F, -f ${SOURCE}/../runs/compare_statistics.awk
  ${FOLDER}/1/results/statistics.csv ${FOLDER}/2/results/statistics.csv
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
require("The statistics of 1 and 2 ranks differ:\n${output}" code EQUAL 0)
