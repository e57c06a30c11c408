# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D PROGRAM=.../reebquad -D OUT=FOLDER -P make_figures.cmake: the manual's figures, made by the program itself.
function(run)
  execute_process(COMMAND ${PROGRAM} ${ARGV} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "reebquad ${ARGV} failed (${status})")
  endif()
endfunction()

file(MAKE_DIRECTORY ${OUT})
run(shape hand -o ${OUT}/hand.obj --triangles 12000)
run(run ${OUT}/hand.obj -o ${OUT}/hand_quads.obj --quads 2500 --pictures ${OUT} --quiet)
