# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause

# How the sources of this project are compiled, in the builds of the repository and of the wheel.

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE}")
endif()

# Packages and wheels are linked with the RPATHs that they are installed with. RPATHs of the build
# would be cut out later, and leave the length of its path and another build ID.
if(WINDING_PACKAGES OR SKBUILD)
  set(CMAKE_BUILD_WITH_INSTALL_RPATH ON)
endif()

option(WINDING_WERROR "Treat warnings as errors" OFF)
set(winding_warnings)
if(NOT MSVC)
  set(winding_warnings -Wall -Wextra -Wshadow $<$<BOOL:${WINDING_WERROR}>:-Werror>)
  # Operators on bits stand where branches could not be foretold.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 14)
    list(APPEND winding_warnings -Wno-bitwise-instead-of-logical)
  endif()
endif()

# What every target of this project is compiled with; no flag of it reaches a consumer.
function(winding_set_warnings target)
  target_compile_options(${target} PRIVATE ${winding_warnings})
endfunction()

option(WINDING_PRECOMPILE "Precompile the headers of others for all targets; for tests it is done anyway" OFF)

# VTK's wheels for x86_64 Linux have the C++ ABI of before C++11. Their helper says so to the module,
# but not to the static core that is linked into it.
option(WINDING_OLD_CXX_ABI "Build for the C++ ABI of before C++11, as VTK's wheels are" OFF)
if(WINDING_OLD_CXX_ABI)
  add_compile_definitions(_GLIBCXX_USE_CXX11_ABI=0)
endif()

# What most files of the filters and of their tests include.
set(winding_vtk_headers
  vtkCellArray.h vtkCellData.h vtkDoubleArray.h vtkFieldData.h vtkFloatArray.h vtkImageData.h
  vtkMultiBlockDataSet.h vtkNew.h vtkPointData.h vtkPoints.h vtkPolyData.h vtkSmartPointer.h
  vtkStringArray.h vtkUnsignedCharArray.h vtkUnstructuredGrid.h)

# winding_precompile(<target> <headers>…): precompiles these headers of others, and the headers
# of the standard library that most files include. A file that forgets one compiles all the same.
# The presets clang and dev find it, which are without, and so is a build without presets.
function(winding_precompile target)
  list(TRANSFORM ARGN PREPEND "$<$<COMPILE_LANGUAGE:CXX>:<" OUTPUT_VARIABLE headers)
  list(TRANSFORM headers APPEND "$<ANGLE-R>>")
  foreach(header algorithm array atomic cmath functional limits map memory numeric string utility vector)
    list(APPEND headers "$<$<COMPILE_LANGUAGE:CXX>:<${header}$<ANGLE-R>>")
  endforeach()
  target_precompile_headers(${target} PRIVATE ${headers})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>) # for ccache
  endif()
endfunction()
