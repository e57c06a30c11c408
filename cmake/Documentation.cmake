# SPDX-License-Identifier: GPL-3.0-or-later
# The target `doc` makes the manual in build/PRESET/doc/html; a warning of Doxygen is an error.
find_package(Doxygen QUIET)
if(DOXYGEN_FOUND)
  set(doc_dir ${PROJECT_SOURCE_DIR}/doc/Reeb_quadrangulation)
  configure_file(${doc_dir}/Doxyfile.in ${PROJECT_BINARY_DIR}/doc/Doxyfile @ONLY)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/doc/figures)
  add_custom_target(doc COMMAND ${DOXYGEN_EXECUTABLE} ${PROJECT_BINARY_DIR}/doc/Doxyfile
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} COMMENT "Making the manual" VERBATIM)
endif()
