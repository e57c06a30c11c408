# SPDX-License-Identifier: GPL-3.0-or-later
# Part of make_page.cmake: the packages of the page in WORK_DIR/node_modules, as WORK_DIR/package-lock.json has them.
set(NPM_LOG ${WORK_DIR}/npm.log)

function(run_npm result)
  execute_process(COMMAND ${NPM} ${ARGN} WORKING_DIRECTORY ${WORK_DIR} RESULT_VARIABLE status
    OUTPUT_VARIABLE output ERROR_VARIABLE output)
  file(APPEND ${NPM_LOG} "npm ${ARGN}\n${output}\n")
  if(NOT status EQUAL 0)
    message("npm ${ARGN} failed:\n${output}")
  endif()
  set(${result} "${status}" PARENT_SCOPE)
endfunction()

# Installs the packages unless they are there already; `result` is 0 if they are there then. `npm ci` takes each package by its
# integrity and leaves the lock as it is, whatever a user's npm would write into one; what a configuration may leave out
# (packages for development) is asked for by name. The lock has the packages of all platforms, or npm refuses it.
function(install_page_packages result)
  set(${result} 0 PARENT_SCOPE)
  file(SHA256 ${WORK_DIR}/package-lock.json lock)
  set(installed "")
  if(EXISTS ${WORK_DIR}/node_modules/.lock)
    file(READ ${WORK_DIR}/node_modules/.lock installed)
  endif()
  if(installed STREQUAL lock)
    return()
  endif()
  run_npm(status ci --package-lock=true --include=dev --include=optional --legacy-peer-deps=false --ignore-scripts
    --no-audit --no-fund)
  if(status EQUAL 0)
    file(WRITE ${WORK_DIR}/node_modules/.lock ${lock})
  endif()
  set(${result} "${status}" PARENT_SCOPE)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  install_page_packages(status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "the packages of the page could not be installed")
  endif()
endif()
