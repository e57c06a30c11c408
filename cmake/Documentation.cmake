# SPDX-License-Identifier: GPL-3.0-or-later
# The target `doc` makes the manual in build/PRESET/doc/html (with the program and an example that draw its figures); a warning of Doxygen is an error.
find_package(Doxygen QUIET)
if(DOXYGEN_FOUND AND TARGET reebquad AND REEBQUAD_TESTS)
  set(doc_dir ${PROJECT_SOURCE_DIR}/doc/Reeb_quadrangulation)
  set(figure_dir ${PROJECT_BINARY_DIR}/doc/figures)
  # The studio's pictures are taken in a browser; without one its page is left out.
  set(studio_pages_excluded ${doc_dir}/studio.md)
  set(studio_figure "")
  if(REEBQUAD_STUDIO AND NPM_PROGRAM AND NODE_PROGRAM AND CHROMIUM_PROGRAM)
    set(studio_pages_excluded "")
    set(studio_figure ${figure_dir}/studio_10.png)
    add_custom_command(OUTPUT ${studio_figure}
      COMMAND ${CMAKE_COMMAND} -E env REEBQUAD_PROGRAM=$<TARGET_FILE:reebquad> CHROMIUM=${CHROMIUM_PROGRAM}
        STUDIO_PAGE_DIR=${PROJECT_BINARY_DIR}/src/studio/page STUDIO_ARTEFACTS=${figure_dir} STUDIO_PICTURES=1
        ${NODE_PROGRAM} ${PROJECT_SOURCE_DIR}/test/studio/tour.mjs
      DEPENDS reebquad ${PROJECT_SOURCE_DIR}/test/studio/tour.mjs ${PROJECT_SOURCE_DIR}/test/studio/harness.mjs
      COMMENT "Taking pictures of the studio" VERBATIM)
  endif()
  # The page of examples: all that there are, each with the first words of its source.
  set(example_list "")
  file(GLOB documented_examples CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/Reeb_quadrangulation/*.cpp)
  foreach(source IN LISTS documented_examples)
    get_filename_component(name ${source} NAME)
    file(STRINGS ${source} words LIMIT_COUNT 2)
    list(GET words 1 words)
    string(REGEX REPLACE "^// *" "" words "${words}")
    string(REPLACE "::" "\\::" words "${words}")
    string(APPEND example_list "/** \\example ${name}\n${words}\n*/\n")
  endforeach()
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/doc/pages/examples.txt CONTENT "${example_list}" @ONLY)
  configure_file(${doc_dir}/Doxyfile.in ${PROJECT_BINARY_DIR}/doc/Doxyfile @ONLY)
  file(GLOB edit_figures CONFIGURE_DEPENDS ${doc_dir}/fig/edits/*.json)
  add_custom_command(OUTPUT ${figure_dir}/quads.png
    COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:reebquad> -D OUT=${figure_dir} -P ${doc_dir}/fig/make_figures.cmake
    DEPENDS reebquad ${doc_dir}/fig/make_figures.cmake ${edit_figures} COMMENT "Making the manual's figures" VERBATIM)
  add_custom_command(OUTPUT ${figure_dir}/texture_move_vertices.svg
    COMMAND ${CMAKE_COMMAND} -E make_directory ${figure_dir}
    COMMAND $<TARGET_FILE:example_texture_pictures> ${figure_dir}
    DEPENDS example_texture_pictures COMMENT "Drawing the texture operators" VERBATIM)
  # Two programs of the course draw their own pictures.
  set(course_figures "")
  foreach(name course_reeb_graph course_texture_traits)
    if(REEBQUAD_TESTS) # it has the examples
      add_custom_command(OUTPUT ${figure_dir}/${name}.png
        COMMAND ${CMAKE_COMMAND} -E make_directory ${figure_dir} COMMAND $<TARGET_FILE:example_${name}> ${figure_dir}
        DEPENDS example_${name} COMMENT "Drawing ${name}" VERBATIM)
      list(APPEND course_figures ${figure_dir}/${name}.png)
    endif()
  endforeach()
  add_custom_target(doc COMMAND ${DOXYGEN_EXECUTABLE} ${PROJECT_BINARY_DIR}/doc/Doxyfile
    DEPENDS ${figure_dir}/quads.png ${figure_dir}/texture_move_vertices.svg ${course_figures} ${studio_figure}
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} COMMENT "Making the manual" VERBATIM)
endif()
# The pictures of README.md, which are committed: `--target readme` makes them anew.
if(REEBQUAD_TESTS)
  add_executable(readme_pictures EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/doc/readme/readme_pictures.cpp)
  target_link_libraries(readme_pictures PRIVATE Reeb_quadrangulation Reeb_quadrangulation_picture reebquad_flags)
  target_compile_options(readme_pictures PRIVATE -O1)
  add_custom_target(readme COMMAND readme_pictures ${PROJECT_SOURCE_DIR}/doc/readme
    ${PROJECT_SOURCE_DIR}/doc/Reeb_quadrangulation/fig/edits COMMENT "Drawing the pictures of README.md" VERBATIM)
endif()
