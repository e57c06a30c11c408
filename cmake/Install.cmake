# SPDX-License-Identifier: GPL-3.0-or-later
# Install rules: headers, the libraries, the program, and what finds them: a CMake package and a pkg-config file.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Reeb_quadrangulation)

install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development FILES_MATCHING PATTERN "*.h")
install(TARGETS Reeb_quadrangulation Reeb_quadrangulation_picture EXPORT Reeb_quadrangulationTargets
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT program NAMELINK_COMPONENT development
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
if(REEBQUAD_CLI)
  install(TARGETS reebquad RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
endif()
install(EXPORT Reeb_quadrangulationTargets NAMESPACE Reeb_quadrangulation:: DESTINATION ${package_dir} COMPONENT development)

# The major version of CGAL that the library was compiled with: its templates are in the binary.
configure_package_config_file(cmake/Reeb_quadrangulationConfig.cmake.in
  ${PROJECT_BINARY_DIR}/Reeb_quadrangulationConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/Reeb_quadrangulationConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
# A static library passes its private dependencies on to the linker, so the module that finds CHOLMOD goes along.
install(FILES ${PROJECT_BINARY_DIR}/Reeb_quadrangulationConfig.cmake
  ${PROJECT_BINARY_DIR}/Reeb_quadrangulationConfigVersion.cmake cmake/FindCHOLMOD.cmake
  DESTINATION ${package_dir} COMPONENT development)

if(REEBQUAD_CHOLMOD)
  set(pc_libs "-lcholmod -lamd -lsuitesparseconfig ")
  set(pc_flags "")
else()
  set(pc_libs "")
  set(pc_flags " -DREEBQUAD_WITHOUT_CHOLMOD")
endif()
file(RELATIVE_PATH pc_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(packaging/reeb_quadrangulation.pc.in ${PROJECT_BINARY_DIR}/reeb_quadrangulation.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/reeb_quadrangulation.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

# `cmake --install BUILD --component cgal-package` makes the folder Reeb_quadrangulation as a release of CGAL has it for each of its
# packages, from the sources alone. Nothing else installs it.
foreach(folder include src examples test benchmark doc package_info cmake packaging)
  install(DIRECTORY ${folder} DESTINATION Reeb_quadrangulation COMPONENT cgal-package EXCLUDE_FROM_ALL
    PATTERN node_modules EXCLUDE PATTERN dist EXCLUDE PATTERN __pycache__ EXCLUDE)
endforeach()
install(FILES CMakeLists.txt LICENSE DESTINATION Reeb_quadrangulation COMPONENT cgal-package EXCLUDE_FROM_ALL)
