# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause

# A port for vcpkg: libwinding, and with the feature vtk filters and program. It was not run; CMake
# has read it with vcpkg's functions replaced (tests/packages/recipes_test.py). The address is a
# placeholder, and ./dev release writes a copy with the hash of the archive that it makes.
vcpkg_check_linkage(ONLY_DYNAMIC_LIBRARY) # libwinding is a shared library
vcpkg_download_distfile(ARCHIVE
  URLS "https://archive.invalid/winding-${VERSION}.tar.gz"
  FILENAME "winding-${VERSION}.tar.gz"
  SHA512 0)
vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${ARCHIVE}")

vcpkg_check_features(OUT_FEATURE_OPTIONS options
  INVERTED_FEATURES vtk WINDING_LIBRARY_ONLY)
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS ${options} -DWINDING_TESTS=OFF)
vcpkg_cmake_install()
vcpkg_copy_pdbs()
if("vtk" IN_LIST FEATURES)
  vcpkg_cmake_config_fixup(PACKAGE_NAME vtkWinding CONFIG_PATH lib/cmake/vtkWinding
    DO_NOT_DELETE_PARENT_CONFIG_PATH)
endif()
vcpkg_cmake_config_fixup(PACKAGE_NAME Winding CONFIG_PATH lib/cmake/Winding)
if("vtk" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES winding AUTO_CLEAN)
endif()
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
