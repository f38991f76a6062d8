# Runs tiny_valve.prm of the folder SOURCE with PROGRAM on 1 and 2 ranks, in
# FOLDER. Asserts that all results are there, that the summary has its keys, that
# energy is balanced within 1 %, and that every column of the statistics is the same on
# both to 1e-9.
cmake_minimum_required(VERSION 3.19)
include(${CMAKE_CURRENT_LIST_DIR}/../run_program.cmake)

function(run ranks)
  set(folder ${FOLDER}/${ranks})
  file(REMOVE_RECURSE ${folder})
  file(COPY ${SOURCE}/tiny_valve.prm ${SOURCE}/pressure.csv DESTINATION ${folder})
  run_program(0 ${ranks} ${folder} tiny_valve.prm)
  require("Not on ${ranks} ranks:\n${output}" output MATCHES "\n${ranks} ranks? on ")
  require("No balance of energy:\n${output}"
    output MATCHES "work of ends +[-0-9.e]+" AND output MATCHES "closure error over the work +[-0-9.e]+ %")
  require("No table of timings:\n${output}" output MATCHES "Coupling +[0-9]+ ")
endfunction()

function(check_files folder)
  foreach(name coapt.log statistics.csv chordae.csv contact_map.vtu contact_map.csv
      coaptation.csv pressure_distribution.csv sections.csv parameters.prm parameters-as-read.prm
      fields/fluid.pvd fields/leaflet.pvd fields/chordae.pvd fields/fluid_00000.pvtu
      fields/fluid_00002.pvtu fields/leaflet_00002.vtu fields/chordae_00002.vtu)
    require("${name} is missing in ${folder}" EXISTS ${folder}/${name})
  endforeach()
  # each collection names files that exist
  foreach(kind fluid leaflet chordae)
    file(STRINGS ${folder}/fields/${kind}.pvd lines REGEX "<DataSet")
    list(LENGTH lines length)
    require("${kind}.pvd has ${length} times, not 3 or 4" length GREATER 2 AND length LESS 5)
    foreach(line ${lines})
      string(REGEX REPLACE ".*file=\"([^\"]*)\".*" "\\1" name "${line}")
      require("${kind}.pvd names ${name}, which is missing" EXISTS ${folder}/fields/${name})
    endforeach()
  endforeach()
endfunction()

# The file of parameters in use can be read again, elsewhere.
function(check_parameters file)
  file(REMOVE_RECURSE ${FOLDER}/again)
  file(COPY ${file} ${SOURCE}/pressure.csv DESTINATION ${FOLDER}/again)
  execute_process(COMMAND ${PROGRAM} --check parameters.prm
    WORKING_DIRECTORY ${FOLDER}/again
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  require("parameters.prm is refused:\n${output}" code EQUAL 0)
endfunction()

function(check_summary file)
  file(READ ${file} text)
  foreach(key sealed closing_time_s leak_mL_per_s flow_peak_mL_per_s closing_volume_mL
      bulging_volume_mL bulging_by_distance_mL work_of_adaptation_relative coaptation_area_mm2 coaptation_force_N contact_force_N
      coaptation_pressure_max_kPa leak_through_tissue_mL_per_s leak_through_gaps_mL_per_s
      leak_drained_mL_per_s regurgitant_volume_mL
      orifice planes segments gaps regions annulus_force_N annulus_force_z_N reynolds_peak stress_mean_kPa strain_mean fluid_cells solid_tets
      steps rhs_evaluations wall_s core_hours energy_error_relative warnings)
    string(JSON value ERROR_VARIABLE error GET "${text}" ${key})
    require("summary.json: ${key}: ${error}" NOT error)
  endforeach()
  foreach(class anterior_primary anterior_secondary posterior_primary posterior_secondary)
    string(JSON value ERROR_VARIABLE error GET "${text}" chordae_peak_N ${class})
    require("summary.json: chordae_peak_N: ${class}: ${error}" NOT error)
  endforeach()
  string(JSON steps GET "${text}" steps)
  string(JSON evaluations GET "${text}" rhs_evaluations)
  math(EXPR least "5 * ${steps}")
  require("${steps} steps are fewer than 200" steps GREATER_EQUAL 200)
  require("${evaluations} evaluations in ${steps} steps" NOT evaluations LESS least)
  string(JSON error GET "${text}" energy_error_relative)
  require("The energy error is ${error}" error LESS 0.01)
  foreach(part work_of_ends work_of_loads work_of_contact losses_viscous losses_impedance
      losses_solid losses_slip energy_kinetic_fluid energy_acoustic energy_kinetic_solid
      energy_elastic energy_multiplier closure_error)
    string(JSON value ERROR_VARIABLE error GET "${text}" energy_J ${part})
    require("summary.json: energy_J: ${part}: ${error}" NOT error)
  endforeach()
  string(JSON sealed GET "${text}" sealed)
  require("An open valve is called sealed" NOT sealed)
endfunction()

run(1)
run(2)
foreach(ranks 1 2)
  check_files(${FOLDER}/${ranks}/results)
  check_summary(${FOLDER}/${ranks}/results/summary.json)
endforeach()
check_parameters(${FOLDER}/1/results/parameters.prm)

execute_process(COMMAND awk -F, -f ${SOURCE}/compare_statistics.awk
  ${FOLDER}/1/results/statistics.csv ${FOLDER}/2/results/statistics.csv
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
message("${output}")
require("The statistics of 1 and 2 ranks differ." code EQUAL 0)
