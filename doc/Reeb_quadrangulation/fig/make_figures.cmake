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

# Textures on the quads of another mesh, quads that follow the curvature, other polygons.
run(run ${OUT}/hand.obj -o ${OUT}/hand_coarse.obj --quads 600 --quiet)
run(texture ${OUT}/hand_coarse.obj --on ${OUT}/hand.obj -o ${OUT}/hand_edited.obj --pictures ${OUT}/base
  --op "subdivide_texture 0.18,0.09,1.3" --quiet)
run(run ${OUT}/hand.obj -o ${OUT}/hand_adaptive.obj --quads 2500 --adaptive --pictures ${OUT}/adaptive --quiet)
run(polygons ${OUT}/hand_quads.obj -o ${OUT}/hand_hex.obj --on ${OUT}/hand.obj --picture ${OUT}/hexagons.png)
foreach(picture base/patches base/quads adaptive/quads)
  string(REPLACE "/" "_" name ${picture})
  file(RENAME ${OUT}/${picture}.png ${OUT}/${name}.png)
endforeach()

set(figure_dir ${CMAKE_CURRENT_LIST_DIR})
# Each recipe in fig/edits is one edit before (all but its last edit) and after.
function(edit_figures shape triangles)
  run(shape ${shape} -o ${OUT}/${shape}.off --triangles ${triangles})
  foreach(name IN LISTS ARGN)
    set(recipe ${figure_dir}/edits/${name}.json)
    file(READ ${recipe} text)
    string(REGEX MATCHALL "\"edit\":" edits "${text}")
    list(LENGTH edits after)
    math(EXPR before "${after} - 1")
    foreach(step before after)
      run(replay ${OUT}/${shape}.off ${recipe} -o ${OUT}/edit.obj --until ${${step}} --pictures ${OUT}/edit --no-relax --quiet)
      foreach(picture charts quads)
        file(RENAME ${OUT}/edit/${picture}.png ${OUT}/${name}_${step}_${picture}.png)
      endforeach()
    endforeach()
  endforeach()
endfunction()
edit_figures(sphere 4000 add_extremum move_extremum subdivide_chart move_contour move_part drag_contour half_pole move_corner
  set_columns set_rows set_shift set_grading texture_polychord texture_inset texture_drag texture_one_sided texture_holes)
edit_figures(torus 4000 half_saddle quarter_saddle pin_corners)
edit_figures(bitorus 4000 align_saddles)
edit_figures(twisted-bar 4000 straighten_contour)
edit_figures(l-shape 4000 snap_contour texture_snap)
