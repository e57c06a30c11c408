# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D BUILD_DIR=... -D WORK_DIR=... -P run.cmake: installs BUILD_DIR into an empty prefix below WORK_DIR, then configures,
# builds and runs the consumer project against that prefix alone, by CMake and by pkg-config; a CGAL of another major version is
# refused; a project that embeds this one gets the library alone.
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "failed (${status}): ${ARGV}")
  endif()
endfunction()

# The prefix with a configuration that says that another CGAL built it: find_package must say so, and stop.
function(check_that_another_cgal_is_refused)
  file(GLOB_RECURSE config ${prefix}/*/Reeb_quadrangulationConfig.cmake)
  file(READ ${config} text)
  string(REGEX REPLACE "STREQUAL \"[0-9]+\"" "STREQUAL \"4\"" other "${text}")
  if(other STREQUAL text)
    message(FATAL_ERROR "${config} compares no major version of CGAL")
  endif()
  file(WRITE ${config} "${other}")
  execute_process(COMMAND ${configure} -B ${WORK_DIR}/refused RESULT_VARIABLE status ERROR_VARIABLE error OUTPUT_QUIET)
  file(WRITE ${config} "${text}")
  if(status EQUAL 0 OR NOT error MATCHES "was built with CGAL")
    message(FATAL_ERROR "another major version of CGAL was not refused: ${error}")
  endif()
endfunction()

function(build_by_pkg_config)
  find_program(PKG_CONFIG pkg-config)
  if(NOT PKG_CONFIG)
    message("pkg-config is not installed: its file is not tested")
    return()
  endif()
  file(GLOB_RECURSE file ${prefix}/*/reeb_quadrangulation.pc)
  get_filename_component(folder ${file} DIRECTORY)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${folder}
    ${PKG_CONFIG} --cflags --libs reeb_quadrangulation
    OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run(${COMPILER} ${CMAKE_CURRENT_LIST_DIR}/main.cpp -o ${WORK_DIR}/by_pkg_config ${flags})
  run(${WORK_DIR}/by_pkg_config)
endfunction()

set(prefix ${WORK_DIR}/prefix)
file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix})
if(EXISTS ${prefix}/Reeb_quadrangulation)
  message(FATAL_ERROR "an ordinary install has the package for a release of CGAL")
endif()
set(configure ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -G Ninja -D CMAKE_BUILD_TYPE=Release
  -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF -D CGAL_DIR=${CGAL_DIR}
  -D CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON)
run(${configure} -B ${WORK_DIR}/build)
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)
run(${WORK_DIR}/build/consumer)
run(${prefix}/bin/reebquad version)
build_by_pkg_config()
check_that_another_cgal_is_refused()
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/embedded -B ${WORK_DIR}/embedded -G Ninja -D CMAKE_BUILD_TYPE=Release
  -D REEBQUAD_SOURCE_DIR=${SOURCE_DIR} -D CGAL_DIR=${CGAL_DIR} -D CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON)
file(REMOVE_RECURSE ${WORK_DIR})
