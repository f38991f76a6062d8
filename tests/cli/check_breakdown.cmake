# Runs the coarse valve COARSE under a pressure that no valve bears, without blood if
# FLUID is none. The run must stop with exit code 1, one line that names time, place (in
# blood) and limiter, and the last fields.
cmake_minimum_required(VERSION 3.18)
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
file(READ ${COARSE} coarse)
file(WRITE ${FOLDER}/blast.csv "time_s,pressure_kPa\n0,0\n0.001,1e5\n1,1e5\n")
file(WRITE ${FOLDER}/case.prm "${coarse}"
  "subsection Ends\n  set Pressure table = blast.csv\n  set Pressure unit = kPa\nend\n"
  "subsection Output\n  set Folder = results\nend\n")
if(FLUID STREQUAL "none")
  file(APPEND ${FOLDER}/case.prm "subsection Structure\n  set Fluid = none\nend\n")
endif()
execute_process(COMMAND ${MPIEXEC} -np ${RANKS} ${PROGRAM} case.prm
  WORKING_DIRECTORY ${FOLDER}
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE error)
if(NOT code EQUAL 1)
  message(FATAL_ERROR "Exit code ${code} instead of 1:\n${output}\n${error}")
endif()
set(place " \\((fluid cell of [0-9.]+ mm at|node of the leaflet, in the beginning at) \\([^\n)]*\\) mm\\)")
set(fields leaflet_00001.vtu chordae_00001.vtu)
if(FLUID STREQUAL "none")
  set(place "")
else()
  list(APPEND fields fluid_00001.pvtu fluid_00001.0.vtu)
endif()
if(NOT error MATCHES "coapt: [^\n]* not finite at t = 0\\.000[0-9]+ s${place}; the step was limited by the [a-z]+\n")
  message(FATAL_ERROR "Another message than expected:\n${error}")
endif()
foreach(file ${fields})
  if(NOT EXISTS ${FOLDER}/results/fields/${file})
    message(FATAL_ERROR "The last finite fields lack ${file}.")
  endif()
endforeach()
