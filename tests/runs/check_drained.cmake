# Runs the drained valve VALVE with PROGRAM on two ranks in FOLDER, with cells of 0.78 mm, under
# the pressure in SOURCE, which shuts it, holds it until 70 ms and pulls it open; and
# then a short while with leaflets that do not reach each other. Asserts that contact carries
# the load and the valve is shut and tight before 70 ms, that it opens cleanly, and
# that short leaflets leak.
cmake_minimum_required(VERSION 3.19)
include(${CMAKE_CURRENT_LIST_DIR}/../run_program.cmake)

file(REMOVE_RECURSE ${FOLDER})
file(COPY ${SOURCE}/drained_pressure.csv DESTINATION ${FOLDER})
file(READ ${VALVE} valve)

# run(NAME TEXT): into the folder NAME, with the parameters TEXT added.
function(run name text)
  file(WRITE ${FOLDER}/${name}.prm "${valve}
subsection Output
  set Folder          = ${name}
  set Fields interval = 1
end
subsection Ends
  set Pressure table = drained_pressure.csv
end
subsection Mesh
  set Coarse cell          = 6.25
  set Sparser points apart = true
end
${text}")
  run_program(0 2 ${FOLDER} ${name}.prm)
endfunction()

# check(NAME WHAT): the statistics of a run.
function(check name what)
  execute_process(COMMAND awk -F, -v what=${what} -f ${SOURCE}/drained.awk
    ${FOLDER}/${name}/statistics.csv
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  message("${name}:\n${output}")
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${name} is not as it should be.")
  endif()
endfunction()

run(healthy "subsection Time
  set End time = 0.11
end")
check(healthy held_and_reopened)
run(short "subsection Time
  set End time = 0.06
end
subsection Valve
  set Anterior height  = 16
  set Posterior height = 10.5
end")
check(short leaks)
