# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D COMPILER=... -D INCLUDES=DIR,DIR -D SOURCE=... -P run.cmake: SOURCE must compile, and with REEBQUAD_LEAVE_OUT,
# which leaves out a requirement of a concept, fail with an error that matches the regular expression after "fails with:".
string(REPLACE "," ";" INCLUDES "${INCLUDES}")
set(command ${COMPILER} -std=c++17 -fsyntax-only -Werror=unused-result)
foreach(directory IN LISTS INCLUDES)
  list(APPEND command -I${directory}) # compilers pass over their own directories, which -isystem would reorder
endforeach()
file(STRINGS ${SOURCE} expected REGEX "^// fails with: " LIMIT_COUNT 1)
string(REPLACE "// fails with: " "" expected "${expected}")
if(expected STREQUAL "")
  message(FATAL_ERROR "${SOURCE} does not say how it fails")
endif()

execute_process(COMMAND ${command} ${SOURCE} RESULT_VARIABLE status ERROR_VARIABLE errors)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "does not compile with all requirements:\n${errors}")
endif()
execute_process(COMMAND ${command} -DREEBQUAD_LEAVE_OUT ${SOURCE} RESULT_VARIABLE status ERROR_VARIABLE errors)
if(status EQUAL 0)
  message(FATAL_ERROR "compiles without the requirement")
endif()
if(NOT errors MATCHES "error: [^\n]*(${expected})")
  message(FATAL_ERROR "fails for another reason than '${expected}':\n${errors}")
endif()
