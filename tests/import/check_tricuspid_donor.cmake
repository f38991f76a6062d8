# Prepares the tricuspid valve from the data in the environment variable COAPT_DATA
# with SOURCE/tools/tricuspid_donor, and runs it with PROGRAM in FOLDER. Asserts that it
# reaches its end with balanced energy, and that the papillary tips have moved
# by what the data say. Skipped without the data.
cmake_minimum_required(VERSION 3.19)
set(data $ENV{COAPT_DATA}/valves/tricuspid_donor_diseased)
if(NOT EXISTS ${data}/leaflets_quad4.msh)
  message("skipped: COAPT_DATA names no folder with valves/tricuspid_donor_diseased")
  return()
endif()

file(REMOVE_RECURSE ${FOLDER})
execute_process(COMMAND ${SOURCE}/tools/tricuspid_donor ${data} ${FOLDER}
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "tools/tricuspid_donor: ${output}")
endif()
execute_process(COMMAND ${PROGRAM} tricuspid_donor.prm WORKING_DIRECTORY ${FOLDER}
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "Exit code ${code}:\n${output}")
endif()

file(READ ${FOLDER}/output/tricuspid_donor/summary.json text)
string(JSON error GET "${text}" energy_error_relative)
if(NOT error LESS 0.02)
  message(FATAL_ERROR "The energy error is ${error}")
endif()
foreach(set annulus papillary)
  string(JSON ${set} GET "${text}" held_displacement_mm ${set})
endforeach()
if(NOT annulus EQUAL 0 OR papillary LESS 3.999 OR papillary GREATER 4.001)
  message(FATAL_ERROR "The annulus has moved by ${annulus} mm instead of 0, the "
    "papillary tips by ${papillary} mm instead of 4")
endif()
string(JSON largest GET "${text}" largest_displacement_mm)
message("largest displacement ${largest} mm")
