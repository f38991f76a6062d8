# Runs tiny_dry.prm of the folder SOURCE with PROGRAM on 1 and 2 ranks, in FOLDER,
# with tetrahedra of the kind ELEMENT.
# Asserts that all results are there, that nothing speaks of blood, that energy is
# balanced, that every column of the statistics is the same on both to 1e-9, and that
# added mass makes steps longer.
cmake_minimum_required(VERSION 3.19)
include(${CMAKE_CURRENT_LIST_DIR}/../run_program.cmake)

foreach(ranks 1 2)
  set(folder ${FOLDER}/${ranks})
  file(REMOVE_RECURSE ${folder})
  file(COPY ${SOURCE}/tiny_dry.prm ${SOURCE}/pressure.csv DESTINATION ${folder})
  file(APPEND ${folder}/tiny_dry.prm "subsection Valve\n  set Element = ${ELEMENT}\nend\n")
  run_program(0 ${ranks} ${folder} tiny_dry.prm)
  require("No table of timings:\n${output}" output MATCHES "Solid +[0-9]+ ")
  foreach(name statistics.csv fields/leaflet.pvd fields/leaflet_00002.vtu
      fields/chordae_00002.vtu)
    require("${name} is missing" EXISTS ${folder}/results/${name})
  endforeach()
  require("There is a fluid" NOT EXISTS ${folder}/results/fields/fluid.pvd)

  file(READ ${folder}/results/summary.json text)
  foreach(key sealed closing_time_s coaptation_force_N contact_force_N chordae_peak_N
      stress_mean_kPa strain_mean solid_tets steps wall_s energy_error_relative)
    string(JSON value ERROR_VARIABLE error GET "${text}" ${key})
    require("summary.json: ${key}: ${error}" NOT error)
  endforeach()
  string(JSON value ERROR_VARIABLE error GET "${text}" leak_mL_per_s)
  require("A valve without fluid leaks ${value}" error)
  string(JSON force GET "${text}" contact_force_N)
  require("There is no contact" force GREATER 0)
  string(JSON error GET "${text}" energy_error_relative)
  require("The energy error is ${error}" error LESS 0.02)
endforeach()

execute_process(COMMAND awk -F, -f ${SOURCE}/compare_statistics.awk
  ${FOLDER}/1/results/statistics.csv ${FOLDER}/2/results/statistics.csv
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
message("${output}")
require("The statistics of 1 and 2 ranks differ." code EQUAL 0)

# Leaflets four times as heavy, with the same drag for their mass, move half as fast and
# need at most half as many steps.
file(READ ${FOLDER}/1/results/summary.json text)
string(JSON steps GET "${text}" steps)
file(APPEND ${FOLDER}/1/tiny_dry.prm
  "subsection Structure\n  set Added mass = 3\n  set Mass damping = 8e4\nend\nsubsection Output\n  set Overwrite = true\nend\n")
execute_process(COMMAND ${PROGRAM} tiny_dry.prm WORKING_DIRECTORY ${FOLDER}/1
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
require("Exit code ${code} with added mass:\n${output}" code EQUAL 0)
file(READ ${FOLDER}/1/results/summary.json text)
string(JSON fewer_steps GET "${text}" steps)
math(EXPR percent "100 * ${fewer_steps} / ${steps}")
require("${fewer_steps} steps with added mass, ${steps} without"
  percent GREATER 20 AND percent LESS 60)
