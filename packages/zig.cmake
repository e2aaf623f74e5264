# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause

# A CMake toolchain: the compilers of the Python package ziglang, which has the headers and libraries
# of C and C++ for many systems. ./dev wheels uses it; docs/library.md says how to.
#
#   WINDING_ZIG         the program zig
#   WINDING_ZIG_TARGET  the system, as x86_64-linux-gnu.2.17 or x86_64-windows-gnu
#   WINDING_ZIG_FOLDER  a folder for wrappers of the compilers
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES
  WINDING_ZIG WINDING_ZIG_TARGET WINDING_ZIG_FOLDER)

string(REGEX MATCH "^([a-z0-9_]+)-([a-z]+)" target "${WINDING_ZIG_TARGET}")
set(CMAKE_SYSTEM_PROCESSOR "${CMAKE_MATCH_1}")
if(CMAKE_MATCH_2 STREQUAL "linux")
  set(CMAKE_SYSTEM_NAME Linux)
elseif(CMAKE_MATCH_2 STREQUAL "windows")
  set(CMAKE_SYSTEM_NAME Windows)
elseif(CMAKE_MATCH_2 STREQUAL "macos")
  set(CMAKE_SYSTEM_NAME Darwin)
  set(CMAKE_OSX_SYSROOT "") # zig has the headers of macOS's C library
else()
  message(FATAL_ERROR "WINDING_ZIG_TARGET is '${WINDING_ZIG_TARGET}': linux, windows or macos")
endif()

# CMake wants one program for each tool, and zig has them as commands. Code is for any processor of
# its kind, and Highway chooses more at run time. zig's own checks are off, and nothing has debug
# information or the names that nobody sees. zig compiles the library of C++ once for each set of
# such flags, so all that is linked has one set.
set(flags "-target ${WINDING_ZIG_TARGET} -mcpu=baseline -O2 -s -g0 -fomit-frame-pointer")
string(APPEND flags " -fno-sanitize=all")
foreach(tool IN ITEMS "cc ${flags}" "c++ ${flags}" ar ranlib rc)
  string(REGEX MATCH "^[a-z+]+" name "${tool}")
  set(wrapper "${WINDING_ZIG_FOLDER}/zig-${name}")
  set(text "#!/bin/sh\nexec '${WINDING_ZIG}' ${tool} \"$@\"\n")
  set(found "")
  if(EXISTS "${wrapper}")
    file(READ "${wrapper}" found)
  endif()
  if(NOT found STREQUAL text)
    file(WRITE "${wrapper}" "${text}")
    file(CHMOD "${wrapper}" PERMISSIONS
      OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  endif()
endforeach()
set(CMAKE_C_COMPILER "${WINDING_ZIG_FOLDER}/zig-cc")
set(CMAKE_CXX_COMPILER "${WINDING_ZIG_FOLDER}/zig-c++")
set(CMAKE_AR "${WINDING_ZIG_FOLDER}/zig-ar" CACHE FILEPATH "")
set(CMAKE_RANLIB "${WINDING_ZIG_FOLDER}/zig-ranlib" CACHE FILEPATH "")
set(CMAKE_RC_COMPILER "${WINDING_ZIG_FOLDER}/zig-rc" CACHE FILEPATH "")
set(CMAKE_INSTALL_NAME_TOOL "${WINDING_ZIG_FOLDER}/zig-cc" CACHE FILEPATH "") # no path is changed
set(CMAKE_SKIP_RPATH ON)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY) # so that no time is spent with linking
