# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause

# winding_install_licence(<package> <library> <files…>): puts the licence of a library that is linked
# into a wheel next to its package. Files are from the library's sources or from Debian's package,
# and those that are there are taken; none is an error.
function(winding_install_licence package library)
  set(found)
  foreach(file IN LISTS ARGN)
    if(EXISTS "${file}")
      cmake_path(GET file FILENAME name)
      install(FILES "${file}" DESTINATION ${package}/licenses RENAME "${library}-${name}.txt")
      list(APPEND found "${file}")
    endif()
  endforeach()
  if(NOT found)
    message(FATAL_ERROR "give the wheel the licence of ${library}: none of ${ARGN} is there")
  endif()
endfunction()

# winding_install_licences(<package>): the licences of what filters/Dependencies.cmake finds.
function(winding_install_licences package)
  winding_install_licence(${package} Highway "${hwy_SOURCE_DIR}/LICENSE"
    "${hwy_SOURCE_DIR}/LICENSE-BSD3" "/usr/share/common-licenses/Apache-2.0"
    "/usr/share/doc/libhwy-dev/copyright")
  winding_install_licence(${package} Eigen "${eigen3_SOURCE_DIR}/COPYING.MPL2"
    "/usr/share/common-licenses/MPL-2.0" "/usr/share/doc/libeigen3-dev/copyright")
  winding_install_licence(${package} nanoflann "${nanoflann_SOURCE_DIR}/COPYING"
    "/usr/share/doc/libnanoflann-dev/copyright")
endfunction()
