# cmake -DSOURCE=... -DHEADER=... -DVERSION=... -P revision.cmake: writes the
# header that says from which revision the program is built, if it changed.
cmake_minimum_required(VERSION 3.18)
set(revision "unknown")
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=10
  OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE
  ERROR_QUIET RESULT_VARIABLE failed)
if(NOT failed)
  set(revision ${described})
endif()
file(CONFIGURE OUTPUT ${HEADER} @ONLY CONTENT
"#define COAPT_VERSION \"@VERSION@\"
#define COAPT_REVISION \"@revision@\"
#define COAPT_PARAMETER_FILES \"@SOURCE@/parameter-files\"
")
