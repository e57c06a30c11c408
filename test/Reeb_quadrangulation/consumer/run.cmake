# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D BUILD_DIR=... -D WORK_DIR=... -P run.cmake: installs BUILD_DIR into an empty prefix below WORK_DIR,
# then configures, builds and runs the consumer project against that prefix alone.
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "failed (${status}): ${ARGV}")
  endif()
endfunction()

set(prefix ${WORK_DIR}/prefix)
file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix})
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK_DIR}/build -G Ninja -D CMAKE_BUILD_TYPE=Release
  -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF -D CGAL_DIR=${CGAL_DIR}
  -D CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON)
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)
run(${WORK_DIR}/build/consumer)
run(${prefix}/bin/reebquad version)
file(REMOVE_RECURSE ${WORK_DIR})
