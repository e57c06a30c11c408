# SPDX-License-Identifier: GPL-3.0-or-later
# An overlay port of the tree that it lies in: vcpkg install reeb-quadrangulation --overlay-ports=packaging/vcpkg
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

vcpkg_check_features(OUT_FEATURE_OPTIONS options
  FEATURES tools REEBQUAD_CLI)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS ${options} -DREEBQUAD_STUDIO=OFF -DREEBQUAD_TESTS=OFF -DREEBQUAD_BENCHMARKS=OFF -DREEBQUAD_INSTALL=ON)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME Reeb_quadrangulation CONFIG_PATH lib/cmake/Reeb_quadrangulation)
vcpkg_fixup_pkgconfig()
if("tools" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES reebquad AUTO_CLEAN)
endif()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
