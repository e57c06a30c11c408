# SPDX-License-Identifier: GPL-3.0-or-later
# Install rules: headers, the static library, the program, and the package config for find_package.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Reeb_quadrangulation)

install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(TARGETS Reeb_quadrangulation Reeb_quadrangulation_picture EXPORT Reeb_quadrangulationTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
if(TARGET reebquad)
  install(TARGETS reebquad RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(EXPORT Reeb_quadrangulationTargets NAMESPACE Reeb_quadrangulation:: DESTINATION ${package_dir})

configure_package_config_file(cmake/Reeb_quadrangulationConfig.cmake.in
  ${PROJECT_BINARY_DIR}/Reeb_quadrangulationConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/Reeb_quadrangulationConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
# A static library passes its private dependencies on to the linker, so the module that finds CHOLMOD goes along.
install(FILES ${PROJECT_BINARY_DIR}/Reeb_quadrangulationConfig.cmake
  ${PROJECT_BINARY_DIR}/Reeb_quadrangulationConfigVersion.cmake cmake/FindCHOLMOD.cmake
  DESTINATION ${package_dir})
