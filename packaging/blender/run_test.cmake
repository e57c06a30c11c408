# SPDX-License-Identifier: GPL-3.0-or-later
# Runs test_addon.py in Blender, with settings and add-ons of its own in WORK_DIR.
if(NOT BLENDER)
  message("SKIP: blender is not installed (Debian: blender), so that its add-on is not tested")
  return()
endif()
file(REMOVE_RECURSE ${WORK_DIR})
file(MAKE_DIRECTORY ${WORK_DIR}/config ${WORK_DIR}/scripts)
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env BLENDER_USER_CONFIG=${WORK_DIR}/config BLENDER_USER_SCRIPTS=${WORK_DIR}/scripts
    ${BLENDER} -b --factory-startup --python-exit-code 1 --python ${CMAKE_CURRENT_LIST_DIR}/test_addon.py -- ${ZIP} ${PROGRAM}
  WORKING_DIRECTORY ${WORK_DIR} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "the add-on's tests failed in Blender (${failed})")
endif()
