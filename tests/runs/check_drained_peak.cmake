# Runs the drained valve VALVE with PROGRAM on two ranks in FOLDER, with cells of
# 0.69 mm, to peak systole under the pressures of TABLE. Asserts that it is sealed with
# a belt of coaptation from commissure to commissure, that contact carries 90 % of the
# force of coaptation (measured 90.75 %), that less than 1 mL/s leaks, with what
# drains, and that re-adapting takes at most 0.1 % of the work of the ends (0.055 %).
cmake_minimum_required(VERSION 3.19)
include(${CMAKE_CURRENT_LIST_DIR}/../run_program.cmake)

file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
file(READ ${VALVE} valve)
file(WRITE ${FOLDER}/peak.prm "${valve}
subsection Output
  set Folder          = results
  set Fields interval = 1
end
subsection Ends
  set Pressure table = ${TABLE}
end
subsection Mesh
  set Coarse cell = 5.555555556
end
")
run_program(0 2 ${FOLDER} peak.prm)

file(READ ${FOLDER}/results/summary.json summary)
foreach(key sealed coaptation_belt_continuous contact_fraction leak_mL_per_s
    energy_error_relative work_of_adaptation_relative)
  string(JSON ${key} GET "${summary}" ${key})
  message("${key}: ${${key}}")
endforeach()
if(NOT sealed OR NOT coaptation_belt_continuous)
  message(FATAL_ERROR "It is not sealed.")
endif()
if(contact_fraction LESS 0.9)
  message(FATAL_ERROR "Contact carries too little.")
endif()
if(leak_mL_per_s GREATER 1)
  message(FATAL_ERROR "It leaks.")
endif()
if(energy_error_relative GREATER 0.005)
  message(FATAL_ERROR "Energy is not balanced.")
endif()
if(work_of_adaptation_relative GREATER 0.001 OR work_of_adaptation_relative LESS -0.001)
  message(FATAL_ERROR "Re-adapting takes or adds energy.")
endif()
