# The libraries that go into the wheel: Highway, and headers of Eigen and nanoflann. What the system
# has of them is taken; auditwheel then carries Highway's library into the wheel. What it lacks is
# fetched and linked statically. The wheel has the licence of each.
#
# Without a network, FETCHCONTENT_SOURCE_DIR_HWY (or _EIGEN3, _NANOFLANN) says where sources are.
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
FetchContent_Declare(Eigen3
  GIT_REPOSITORY https://gitlab.com/libeigen/eigen.git
  GIT_TAG 3.4.0
  EXCLUDE_FROM_ALL SYSTEM
  FIND_PACKAGE_ARGS 3.4 NO_MODULE)
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

# winding_install_licence(<library> <files…>): those that are there, of its sources or of Debian's
# package; none is an error.
function(winding_install_licence library)
  set(found)
  foreach(file IN LISTS ARGN)
    if(EXISTS "${file}")
      cmake_path(GET file FILENAME name)
      install(FILES "${file}" DESTINATION vtkwinding/licenses RENAME "${library}-${name}.txt")
      list(APPEND found "${file}")
    endif()
  endforeach()
  if(NOT found)
    message(FATAL_ERROR "give the wheel the licence of ${library}: none of ${ARGN} is there")
  endif()
endfunction()

winding_install_licence(Highway "${hwy_SOURCE_DIR}/LICENSE" "${hwy_SOURCE_DIR}/LICENSE-BSD3"
  "/usr/share/common-licenses/Apache-2.0" "/usr/share/doc/libhwy-dev/copyright")
winding_install_licence(Eigen "${eigen3_SOURCE_DIR}/COPYING.MPL2"
  "/usr/share/common-licenses/MPL-2.0" "/usr/share/doc/libeigen3-dev/copyright")
winding_install_licence(nanoflann "${nanoflann_SOURCE_DIR}/COPYING"
  "/usr/share/doc/libnanoflann-dev/copyright")
