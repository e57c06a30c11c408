# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D PROGRAM=.../reebquad -D OUT=FOLDER -P make_figures.cmake: the manual's figures, made by the program itself.
# Meshes and pictures not shown go to OUT_work: the manual's figures are found by their names alone.
function(run)
  execute_process(COMMAND ${PROGRAM} ${ARGV} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "reebquad ${ARGV} failed (${status})")
  endif()
endfunction()

set(work ${OUT}_work)
file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${OUT} ${work})

# show(FOLDER PICTURE...): these pictures of a run become figures named FOLDER_PICTURE.
function(show folder)
  foreach(picture IN LISTS ARGN)
    file(RENAME ${work}/${folder}/${picture}.png ${OUT}/${folder}_${picture}.png)
  endforeach()
endfunction()

run(shape hand -o ${work}/hand.obj --triangles 12000)
run(run ${work}/hand.obj -o ${work}/hand_quads.obj --quads 2500 --pictures ${OUT} --quiet)

# Textures on the quads of another mesh, quads that follow the curvature, other polygons.
run(run ${work}/hand.obj -o ${work}/hand_coarse.obj --quads 600 --quiet)
run(texture ${work}/hand_coarse.obj --on ${work}/hand.obj -o ${work}/hand_edited.obj --pictures ${work}/base
  --op "subdivide_texture 0.18,0.09,1.3" --quiet)
show(base patches quads)
run(run ${work}/hand.obj -o ${work}/hand_adaptive.obj --quads 2500 --adaptive --pictures ${work}/adaptive --quiet)
show(adaptive quads)
# Sharp edges by single vertices and by whole lines; designs of the paper.
foreach(shape l-shape twisted-bar bitorus)
  run(shape ${shape} -o ${work}/${shape}.obj --triangles 7000)
endforeach()
run(run ${work}/l-shape.obj -o ${work}/single.obj --quads 1500 --pictures ${work}/sharp_single --quiet)
run(run ${work}/l-shape.obj -o ${work}/lines.obj --quads 1500 --feature-lines --pictures ${work}/sharp_lines --quiet)
show(sharp_single quads)
show(sharp_lines quads)
set(recipes ${CMAKE_CURRENT_LIST_DIR}/../../../test/Reeb_quadrangulation/recipes)
foreach(design l-shape:l_shape_polycube twisted-bar:twisted_bar bitorus:bitorus_half)
  string(REPLACE ":" ";" design ${design})
  list(GET design 0 shape)
  list(GET design 1 recipe)
  run(replay ${work}/${shape}.obj ${recipes}/${recipe}.json -o ${work}/${recipe}.obj --feature-lines
    --pictures ${work}/design_${recipe} --quiet)
  show(design_${recipe} quads)
endforeach()
# The course: the field of its second program and the charts of its fourth, the Reeb graph of its third and the quads of its fifth.
run(shape torus -o ${work}/torus_4000.obj --triangles 4000)
run(run ${work}/torus_4000.obj -o ${work}/course_torus.obj --quads 1000 --min 1.4,0,0 --max -1.4,0,0 --effort fast
  --pictures ${work}/course_torus --quiet)
show(course_torus field charts)
run(run ${work}/bitorus.obj -o ${work}/course_bitorus.obj --quads 1500 --effort fast --pictures ${work}/course_bitorus --quiet)
show(course_bitorus reeb_graph quads)
run(polygons ${work}/hand_quads.obj -o ${work}/hand_hex.obj --on ${work}/hand.obj --picture ${OUT}/hexagons.png)

set(figure_dir ${CMAKE_CURRENT_LIST_DIR})
# Each recipe in fig/edits is one edit before (all but its last edit) and after.
function(edit_figures shape triangles)
  run(shape ${shape} -o ${work}/${shape}.off --triangles ${triangles})
  foreach(name IN LISTS ARGN)
    set(recipe ${figure_dir}/edits/${name}.json)
    file(READ ${recipe} text)
    string(REGEX MATCHALL "\"edit\":" edits "${text}")
    list(LENGTH edits after)
    math(EXPR before "${after} - 1")
    foreach(step before after)
      run(replay ${work}/${shape}.off ${recipe} -o ${work}/edit.obj --until ${${step}} --pictures ${work}/edit --no-relax --quiet)
      foreach(picture charts quads)
        file(RENAME ${work}/edit/${picture}.png ${OUT}/${name}_${step}_${picture}.png)
      endforeach()
    endforeach()
  endforeach()
endfunction()
edit_figures(sphere 4000 add_extremum move_extremum subdivide_chart move_contour move_part drag_contour half_pole whole_pole move_corner
  set_columns set_rows set_shift set_grading add_dislocation texture_polychord texture_inset texture_drag texture_one_sided texture_holes)
edit_figures(torus 4000 move_saddle half_saddle quarter_saddle pin_corners)
edit_figures(bitorus 4000 align_saddles)
edit_figures(twisted-bar 4000 straighten_contour texture_fit)
edit_figures(l-shape 4000 snap_contour texture_snap)
