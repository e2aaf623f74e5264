# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause

# What libwinding and the wheels are built with: Highway, and headers of Eigen and nanoflann. What the
# system has of them is taken. What it lacks is fetched, and Highway then linked statically.
#
# FETCHCONTENT_SOURCE_DIR_HWY (or _EIGEN3, _NANOFLANN) names a folder of sources, which are taken
# before the system's and without a network.
include(FetchContent)

# Highway knows cache variables only.
set(BUILD_SHARED_LIBS OFF CACHE BOOL "" FORCE)
foreach(part IN ITEMS TESTS EXAMPLES CONTRIB INSTALL)
  set(HWY_ENABLE_${part} OFF CACHE BOOL "" FORCE)
endforeach()
FetchContent_Declare(hwy
  GIT_REPOSITORY https://github.com/google/highway.git
  GIT_TAG 58746ca5b9f9444a2a3549704602ecc6239f8f41 # 1.0.3
  EXCLUDE_FROM_ALL SYSTEM
  FIND_PACKAGE_ARGS)
set(EIGEN_BUILD_DOC OFF CACHE BOOL "" FORCE)
set(EIGEN_BUILD_TESTING OFF CACHE BOOL "" FORCE)
# Eigen 5 refuses a request for 3.4, and an older one is left alone.
set(eigen_of_system OVERRIDE_FIND_PACKAGE) # so that find_package() finds what is fetched
if(NOT FETCHCONTENT_SOURCE_DIR_EIGEN3)
  find_package(Eigen3 3.4 QUIET NO_MODULE)
  if(NOT Eigen3_FOUND)
    find_package(Eigen3 5 QUIET NO_MODULE)
  endif()
  if(Eigen3_FOUND)
    set(eigen_of_system FIND_PACKAGE_ARGS NO_MODULE)
  endif()
endif()
FetchContent_Declare(Eigen3
  GIT_REPOSITORY https://gitlab.com/libeigen/eigen.git
  GIT_TAG 3.4.0
  EXCLUDE_FROM_ALL SYSTEM
  ${eigen_of_system})
set(NANOFLANN_BUILD_EXAMPLES OFF CACHE BOOL "" FORCE)
set(NANOFLANN_BUILD_TESTS OFF CACHE BOOL "" FORCE)
FetchContent_Declare(nanoflann
  GIT_REPOSITORY https://github.com/jlblancoc/nanoflann.git
  GIT_TAG 2f54b8eb07c719bc605445e4ec44d61240f5a2ce # 1.4.3
  EXCLUDE_FROM_ALL SYSTEM
  FIND_PACKAGE_ARGS)
FetchContent_MakeAvailable(hwy Eigen3 nanoflann)
if(NOT TARGET hwy::hwy)
  add_library(hwy::hwy ALIAS hwy)
endif()
if(CMAKE_CROSSCOMPILING AND EXISTS /usr/include/nanoflann.hpp)
  # The system's one lies among headers of the system, which are not the target's.
  set(winding_headers "${CMAKE_BINARY_DIR}/headers")
  file(MAKE_DIRECTORY "${winding_headers}")
  file(CREATE_LINK /usr/include/nanoflann.hpp "${winding_headers}/nanoflann.hpp" SYMBOLIC)
  set_target_properties(nanoflann::nanoflann PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${winding_headers}")
endif()
