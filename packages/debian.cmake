# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause

# Debian packages by CPack, from a build for the prefix /usr (the presets package and
# package-paraview, which ./dev packages builds). The VTK that was built against decides which one:
# vtk-winding for Debian's VTK, paraview-winding for that in Debian's ParaView. They may be installed
# together.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(WINDING_CONTACT "The Winding developers <nobody@winding.invalid>" CACHE STRING
  "Who makes the Debian packages: a name, and an address in angle brackets")
if(NOT WINDING_CONTACT MATCHES "^[^<]+ <[^ @]+@[^ @]+>$")
  message(FATAL_ERROR "WINDING_CONTACT is '${WINDING_CONTACT}': a changelog of Debian wants a name "
    "and an address, as in 'Jane Doe <jane@example.org>'")
endif()
set(CPACK_PACKAGE_CONTACT "${WINDING_CONTACT}")
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_PACKAGING_INSTALL_PREFIX "${CMAKE_INSTALL_PREFIX}")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)

# Sets `result` to the package of an installed library, of its version or a newer one.
function(winding_package_of library result)
  execute_process(COMMAND dpkg-query --search "*/${CMAKE_LIBRARY_ARCHITECTURE}/${library}"
    OUTPUT_VARIABLE package COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE ": .*" "" package "${package}")
  execute_process(COMMAND dpkg-query --show --showformat "\${source:Upstream-Version}" "${package}"
    OUTPUT_VARIABLE version COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE ":.*" "" package "${package}")
  string(REGEX MATCH "^[0-9]+\\.[0-9]+" version "${version}")
  set(${result} "${package} (>= ${version})" PARENT_SCOPE)
endfunction()

if(WINDING_PARAVIEW)
  set(CPACK_PACKAGE_NAME paraview-winding)
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Winding-number fields in ParaView")
  set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
    "Filters that tell inside from outside on surfaces with holes, overlaps and\n\
gaps, and on clouds of points with normals: fields, closed surfaces, voxels,\n\
queries, reports. ParaView loads them when it starts, or lists them in Tools,\n\
Manage Plugins.")
  set(CPACK_COMPONENTS_ALL runtime Unspecified) # nothing to build with
  # ParaView's libraries lie in no package that dpkg-shlibdeps could ask here: python3-paraview
  # excludes python3-vtk9, so ParaView is not installed where both packages are made.
  set(oldest "${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}")
  math(EXPR minor "${ParaView_VERSION_MINOR} + 1")
  set(depends "paraview (>= ${oldest})" "paraview (<< ${ParaView_VERSION_MAJOR}.${minor})")
  foreach(library IN ITEMS libc.so.6 libgcc_s.so.1 libhwy.so.1 libstdc++.so.6)
    winding_package_of(${library} package)
    list(APPEND depends "${package}")
  endforeach()
  list(JOIN depends ", " CPACK_DEBIAN_PACKAGE_DEPENDS)
  if(EXISTS "${ParaView_DIR}/../../paraview-${oldest}/paraview.conf")
    # Debian's own file, of Debian 13 and later, is the only one that is read. It names a folder:
    # plugins in there are listed, for users to load, or to have loaded always.
    set(listed "${CMAKE_BINARY_DIR}/listed/WindingNumbers.so")
    file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/listed")
    file(RELATIVE_PATH plugin "${CMAKE_INSTALL_PREFIX}/${winding_listed_folder}"
      "${CMAKE_INSTALL_PREFIX}/${winding_library_folder}/WindingNumbers.so")
    file(CREATE_LINK "${plugin}" "${listed}" SYMBOLIC)
    install(FILES "${listed}" DESTINATION "${winding_listed_folder}")
  else()
    # ParaView's programs load what paraview.conf next to them names.
    file(RELATIVE_PATH plugins "${CMAKE_INSTALL_FULL_BINDIR}"
      "${CMAKE_INSTALL_PREFIX}/${winding_plugins_folder}/winding.plugins.xml")
    file(GENERATE OUTPUT "${CMAKE_BINARY_DIR}/paraview.conf" CONTENT "${plugins}\n")
    install(FILES "${CMAKE_BINARY_DIR}/paraview.conf" DESTINATION "${CMAKE_INSTALL_BINDIR}")
  endif()
else()
  set(CPACK_PACKAGE_NAME vtk-winding)
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Winding-number fields for VTK")
  set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
    "Filters that tell inside from outside on surfaces with holes, overlaps and\n\
gaps, and on clouds of points with normals: fields, closed surfaces, voxels,\n\
queries, reports. The program winding, the VTK module for C++ and CMake, and\n\
the Python packages vtkwinding and vtkwinding_native.")
  set(CPACK_COMPONENTS_ALL runtime development python Unspecified)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
  # The wrappers are for one version of Python.
  math(EXPR minor "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PACKAGE_DEPENDS
    "python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}), python3 (<< 3.${minor})")
  # CPack's shlibs would ask for the very version that a program was built with, and CPack adds no
  # trigger for ldconfig.
  set(later "vtk-winding (>= ${PROJECT_VERSION})")
  set(control "${CMAKE_BINARY_DIR}/control")
  file(WRITE "${control}/shlibs"
    "libvtkFiltersWinding ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} ${later}\n"
    "libvtkIOWinding ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} ${later}\n"
    "libwinding 1 ${later}\n")
  file(WRITE "${control}/triggers" "activate-noawait ldconfig\n")
  set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${control}/shlibs;${control}/triggers")
  set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
  set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-vtk9, python3-numpy")
  set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libvtk9-dev, paraview-winding")
endif()

# What Debian's policy asks for: the licences in a form for machines, and changelogs and man pages
# that are compressed. gzip is given no name and no time, so that the bytes are the same again.
set(documents "${CMAKE_INSTALL_DATADIR}/doc/${CPACK_PACKAGE_NAME}")
file(READ "${PROJECT_SOURCE_DIR}/LICENSE" licence)
string(REGEX REPLACE "^[^\n]*\n\n[^\n]*\n\n" "" licence "${licence}") # its name, and whose it is
string(STRIP "${licence}" licence)
string(REPLACE "\n\n" "\n.\n" licence "${licence}")
string(REPLACE "\n" "\n " licence " ${licence}")
configure_file(packages/debian/copyright.in "${CMAKE_BINARY_DIR}/copyright" @ONLY)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(packages/debian/changelog.in "${CMAKE_BINARY_DIR}/changelog.Debian" @ONLY)
configure_file(CHANGELOG.md "${CMAKE_BINARY_DIR}/changelog" COPYONLY)
configure_file(packages/debian/${CPACK_PACKAGE_NAME}.overrides "${CMAKE_BINARY_DIR}/overrides"
  COPYONLY)
install(FILES "${CMAKE_BINARY_DIR}/changelog" "${CMAKE_BINARY_DIR}/changelog.Debian"
  "${CMAKE_BINARY_DIR}/copyright" DESTINATION "${documents}" COMPONENT runtime)
install(FILES "${CMAKE_BINARY_DIR}/overrides"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/lintian/overrides" RENAME "${CPACK_PACKAGE_NAME}"
  COMPONENT runtime)
install(CODE "
  set(share \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/share\")
  file(GLOB texts \"\${share}/man/man1/*.1\" \"\${share}/doc/*/changelog*\")
  execute_process(COMMAND gzip -9nf \${texts} COMMAND_ERROR_IS_FATAL ANY)" COMPONENT runtime)
include(CPack)
