# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D ZIP=FILE -P make_zip.cmake: the add-on as Blender installs it (Edit > Preferences > Add-ons > Install).
cmake_minimum_required(VERSION 3.21)
get_filename_component(zip "${ZIP}" ABSOLUTE)
file(GLOB sources RELATIVE ${CMAKE_CURRENT_LIST_DIR} ${CMAKE_CURRENT_LIST_DIR}/reebquad_blender/*.py)
execute_process(COMMAND ${CMAKE_COMMAND} -E tar cf ${zip} --format=zip -- ${sources}
  WORKING_DIRECTORY ${CMAKE_CURRENT_LIST_DIR} COMMAND_ERROR_IS_FATAL ANY)
message(STATUS "${zip}")
