# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause

# The static libraries that the VTK modules are made of, each in the folder of its name. The top
# level has made some of them; in another tree of modules, the first module makes them.
if(NOT DEFINED winding_warnings)
  include("${CMAKE_CURRENT_LIST_DIR}/Compiling.cmake")
endif()
if(WINDING_COVERAGE)
  add_compile_options(--coverage -fprofile-update=atomic)
endif()

# winding_need_parts(<part>…)
function(winding_need_parts)
  foreach(part IN LISTS ARGN)
    if(NOT TARGET winding_${part})
      add_subdirectory("../${part}" "${CMAKE_CURRENT_BINARY_DIR}/${part}")
    endif()
  endforeach()
endfunction()

# winding_export_parts(<part>…): consumers of a static module link what it is made of themselves.
# The name of the export is an argument of vtk_module_build().
function(winding_export_parts)
  if(NOT BUILD_SHARED_LIBS)
    list(TRANSFORM ARGN PREPEND winding_)
    install(TARGETS ${ARGN}
      EXPORT "${_vtk_build_INSTALL_EXPORT}"
      DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  endif()
endfunction()
