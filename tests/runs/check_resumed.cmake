# Interrupts tiny_valve.prm of the folder SOURCE, with PROGRAM in FOLDER, and lets it go
# on from its checkpoint on 1 and 2 ranks. Asserts that every column of the statistics
# is, to 1e-9, the same as in one go (REFERENCE), that the other tables are as long and
# the collections name as many files; and that a checkpoint that is missing, damaged or
# of other meshes is refused.
cmake_minimum_required(VERSION 3.19)
include(${CMAKE_CURRENT_LIST_DIR}/../run_program.cmake)

# run(EXPECTED_CODE RANKS CHANGE...): with these lines added to the file.
function(run expected ranks)
  file(READ ${SOURCE}/tiny_valve.prm text)
  foreach(change ${ARGN})
    string(APPEND text "${change}\n")
  endforeach()
  file(WRITE ${FOLDER}/resumed.prm "${text}")
  run_program(${expected} ${ranks} ${FOLDER} resumed.prm)
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(count_lines file result)
  file(STRINGS ${file} lines)
  list(LENGTH lines length)
  set(${result} ${length} PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${FOLDER})
file(COPY ${SOURCE}/pressure.csv DESTINATION ${FOLDER})

run(2 1 "subsection Output" "set Resume = true" "end")
require("No word of the missing checkpoint:\n${output}" output MATCHES "has no checkpoint to go on from")

run(0 1 "subsection Time" "set End time = 4.4e-4" "end"
  "subsection Output" "set Checkpoint interval = 1e-9" "set Resume = auto" "end")
file(RENAME ${FOLDER}/results ${FOLDER}/interrupted)
require("There is no checkpoint" EXISTS ${FOLDER}/interrupted/checkpoint/state)
# as if the program had been killed while one takes the place of another
file(RENAME ${FOLDER}/interrupted/checkpoint ${FOLDER}/interrupted/checkpoint-old)
# and had come further
file(APPEND ${FOLDER}/interrupted/statistics.csv "a row that is too much\n")

foreach(ranks 1 2)
  file(REMOVE_RECURSE ${FOLDER}/results)
  file(COPY ${FOLDER}/interrupted/ DESTINATION ${FOLDER}/results)
  run(0 ${ranks} "subsection Output" "set Resume = auto" "end")
  require("No word of the checkpoint:\n${output}" output MATCHES "goes on from")
  execute_process(COMMAND awk -F, -f ${SOURCE}/compare_statistics.awk
    ${REFERENCE}/statistics.csv ${FOLDER}/results/statistics.csv
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  require("The statistics differ on ${ranks} ranks:\n${output}" code EQUAL 0)
  foreach(table chordae.csv surface_load.csv contact_map.csv fields/fluid.pvd
      fields/leaflet.pvd fields/chordae.pvd)
    count_lines(${REFERENCE}/${table} expected)
    count_lines(${FOLDER}/results/${table} found)
    require("${table} has ${found} lines instead of ${expected}" found EQUAL expected)
  endforeach()
endforeach()

# A run that has come to its end stays there.
file(SHA1 ${FOLDER}/results/statistics.csv expected)
run(0 2 "subsection Output" "set Resume = true" "end")
file(SHA1 ${FOLDER}/results/statistics.csv found)
require("A run at its end has gone on:\n${output}" found STREQUAL "${expected}"
  AND output MATCHES "goes on from")

foreach(name statistics.csv parameters.prm summary.json)
  file(SHA1 ${FOLDER}/results/${name} hash_${name})
endforeach()
run(2 2 "subsection Output" "set Resume = auto" "end"
  "subsection Valve" "set Elements around = 48" "end")
require("Other meshes are not refused as such:\n${output}"
  output MATCHES "nodes of the leaflets, but these parameters ask for")

run(2 2 "subsection Output" "set Resume = true" "end" "subsection Time" "set End time = 4e-4" "end")
require("An end before the checkpoint is not refused as such:\n${output}"
  output MATCHES "must not be before the checkpoint")

set(checkpoint ${FOLDER}/results/checkpoint)
execute_process(COMMAND truncate -s 100000 ${checkpoint}/octree_fixed.data)
run(2 2 "subsection Output" "set Resume = true" "end")
require("Half an octree is not refused as such:\n${output}"
  output MATCHES "octree_fixed.data is missing or incomplete")
file(REMOVE_RECURSE ${checkpoint})
file(COPY ${FOLDER}/interrupted/checkpoint-old DESTINATION ${FOLDER}/results)
file(RENAME ${checkpoint}-old ${checkpoint})
execute_process(COMMAND truncate -s 100000 ${checkpoint}/state)
run(2 2 "subsection Output" "set Resume = true" "end")
require("Half a file is not refused as such:\n${output}" output MATCHES "state is damaged")
file(WRITE ${checkpoint}/state "nonsense")
run(2 2 "subsection Output" "set Resume = true" "end")
require("Nonsense is not refused as such:\n${output}" output MATCHES "state is no checkpoint")
foreach(name statistics.csv parameters.prm summary.json)
  file(SHA1 ${FOLDER}/results/${name} found)
  require("Runs that have not begun have changed ${name}" found STREQUAL "${hash_${name}}")
endforeach()
