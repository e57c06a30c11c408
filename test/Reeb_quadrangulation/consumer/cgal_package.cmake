# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D BUILD_DIR=... -D WORK_DIR=... -P cgal_package.cmake: installs the package as a release of CGAL has
# it and reads it: its parts are there and no others, `dependencies` names the packages of CGAL that it
# includes and no others, each source has its licence, no path of this machine is inside; its examples are a
# project that configures, with the library around them.
cmake_policy(SET CMP0057 NEW)
set(faults 0)

macro(fault)
  message("cgal_package: ${ARGN}")
  math(EXPR faults "${faults} + 1")
endmacro()

set(package ${WORK_DIR}/Reeb_quadrangulation)
file(REMOVE_RECURSE ${WORK_DIR})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --component cgal-package --prefix ${WORK_DIR}
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

# Its parts.
set(information copyright dependencies description.txt license.txt long_description.txt maintainer)
list(TRANSFORM information PREPEND package_info/Reeb_quadrangulation/)
foreach(part IN LISTS information ITEMS include/CGAL/reeb_quadrangulation.h
  include/CGAL/Reeb_quadrangulation/quadrangulate.h src/core examples/Reeb_quadrangulation/surface_mesh.cpp
  test/Reeb_quadrangulation/CMakeLists.txt benchmark/Reeb_quadrangulation
  doc/Reeb_quadrangulation/PackageDescription.txt doc/Reeb_quadrangulation/Reeb_quadrangulation.md LICENSE)
  if(NOT EXISTS ${package}/${part})
    fault("${part} is missing")
  endif()
endforeach()
file(GLOB beside RELATIVE ${WORK_DIR} ${WORK_DIR}/*)
if(NOT beside STREQUAL "Reeb_quadrangulation")
  fault("more is installed than the package: ${beside}")
endif()
file(STRINGS ${package}/package_info/Reeb_quadrangulation/description.txt lines)
list(LENGTH lines count)
if(NOT count EQUAL 1)
  fault("description.txt has ${count} lines; CGAL's list of packages has room for one")
endif()

# Licences and paths.
file(GLOB_RECURSE files RELATIVE ${package} ${package}/*)
foreach(file IN LISTS files)
  if(file MATCHES "\\.png$|/corpus/")
    continue()
  endif()
  file(READ ${package}/${file} text)
  foreach(path ${SOURCE_DIR} ${BUILD_DIR} ${WORK_DIR})
    string(FIND "${text}" ${path} where)
    if(NOT where EQUAL -1)
      fault("${file} has the path ${path} of this machine")
    endif()
  endforeach()
  if(file MATCHES "\\.(h|cpp|cmake)$|/CMakeLists\\.txt$")
    string(SUBSTRING "${text}" 0 300 head)
    if(NOT head MATCHES "SPDX-License-Identifier: GPL-3.0-or-later")
      fault("${file} has no licence line")
    endif()
  endif()
endforeach()

# Every header of CGAL says in a line "$URL: .../v5.5.1/AABB_tree/include/CGAL/..." which package it belongs
# to.
file(GLOB_RECURSE sources ${package}/include/*.h ${package}/src/core/*.h ${package}/src/core/*.cpp
  ${package}/src/picture/*.cpp)
set(includes "")
foreach(source IN LISTS sources)
  file(STRINGS ${source} lines REGEX "^#include <CGAL/")
  list(APPEND includes ${lines})
endforeach()
list(REMOVE_DUPLICATES includes)
string(REPLACE ";" "\n" includes "${includes}")
file(WRITE ${WORK_DIR}/includes.cpp "${includes}\n")
string(REPLACE "," ";" folders "${INCLUDES}")
list(TRANSFORM folders PREPEND -I)
# Headers that this version of CGAL has not are passed over (-MG): the sources choose by its version.
execute_process(COMMAND ${COMPILER} -std=c++17 -w -M -MG -I${package}/include ${folders} ${WORK_DIR}/includes.cpp
  OUTPUT_VARIABLE reached COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^ \\\n]+/CGAL/[^ \\\n]+" reached "${reached}")
set(found "")
foreach(header IN LISTS reached)
  if(NOT EXISTS ${header})
    continue()
  endif()
  file(STRINGS ${header} url REGEX "\\$URL: .*/(include|src)/" LIMIT_COUNT 1)
  if(url MATCHES "/v[0-9.]+[^/]*/([A-Za-z0-9_]+)/include/")
    list(APPEND found ${CMAKE_MATCH_1})
  endif()
endforeach()
list(REMOVE_DUPLICATES found)
list(LENGTH found count)
if(count LESS 10)
  fault("only these packages were found: ${found}")
endif()
file(STRINGS ${package}/package_info/Reeb_quadrangulation/dependencies declared)
foreach(name IN LISTS found)
  if(NOT name IN_LIST declared)
    fault("package_info/Reeb_quadrangulation/dependencies does not name ${name}")
  endif()
endforeach()
set(own_or_reached_by_cgal_6_alone Reeb_quadrangulation CGAL_Core)
foreach(name IN LISTS declared)
  if(NOT name IN_LIST found AND NOT name IN_LIST own_or_reached_by_cgal_6_alone)
    fault("package_info/Reeb_quadrangulation/dependencies names ${name}, of which nothing is included")
  endif()
endforeach()

execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${package}/examples/Reeb_quadrangulation -B ${WORK_DIR}/examples -G Ninja
  -D CMAKE_BUILD_TYPE=Release -D CGAL_DIR=${CGAL_DIR} -D CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON
  RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(NOT status EQUAL 0)
  fault("the examples of the package do not configure: ${said}")
endif()
if(faults GREATER 0)
  message(FATAL_ERROR "${faults} faults")
endif()
file(REMOVE_RECURSE ${WORK_DIR})
