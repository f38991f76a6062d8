# cmake -DSOURCE=... -P check_includes.cmake: reads the dependency rule, the
# lines coapt_area(NAME ALLOWED...), and compares all #include <coapt/...> with
# it. The type chordae/chorda.h depends on nothing and is free for all.
cmake_minimum_required(VERSION 3.18)

file(STRINGS ${SOURCE}/CMakeLists.txt rules REGEX "^coapt_area\\([a-z ]+\\)")
if(NOT rules)
  message(FATAL_ERROR "No rule found in ${SOURCE}/CMakeLists.txt")
endif()

set(violations "")
set(n_includes 0)
foreach(rule ${rules})
  string(REGEX MATCH "\\(([a-z ]+)\\)" unused "${rule}")
  string(REPLACE " " ";" allowed "${CMAKE_MATCH_1}")
  list(GET allowed 0 area)

  file(GLOB_RECURSE files RELATIVE ${SOURCE}
    ${SOURCE}/source/${area}/*.cc ${SOURCE}/include/coapt/${area}/*.h)
  foreach(file ${files})
    file(STRINGS ${SOURCE}/${file} includes REGEX "^#include <coapt/")
    foreach(include ${includes})
      string(REGEX MATCH "<coapt/([a-z]+)/([a-z_/]+\\.h)>" unused "${include}")
      math(EXPR n_includes "${n_includes} + 1")
      if(NOT "${CMAKE_MATCH_1}" IN_LIST allowed AND
         NOT "${CMAKE_MATCH_1}/${CMAKE_MATCH_2}" STREQUAL "chordae/chorda.h")
        list(APPEND violations "${file}: ${include}")
      endif()
    endforeach()
  endforeach()
endforeach()

if(n_includes EQUAL 0)
  message(FATAL_ERROR "No #include <coapt/...> found below ${SOURCE}")
endif()
if(violations)
  string(REPLACE ";" "\n  " violations "${violations}")
  message(FATAL_ERROR "Not allowed by CMakeLists.txt:\n  ${violations}")
endif()
message(STATUS "${n_includes} includes keep the rule")
