# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause

# Type stubs of the wrapped modules, by VTK's generator. It imports the package from the build tree;
# the libraries of the wheel vtk have to be there before the module finds the SDK's.
set(package "${CMAKE_CURRENT_BINARY_DIR}/vtkwinding_native")
set(modules vtkFiltersWinding vtkIOWinding)
set(stubs ${modules})
list(TRANSFORM stubs REPLACE ".+" "${package}/\\0.pyi")
foreach(source IN ITEMS __init__.py _vtk.py)
  configure_file(vtkwinding_native/${source} "${package}/${source}" COPYONLY)
endforeach()
configure_file(_built.py.in "${package}/_built.py" @ONLY)
add_custom_command(OUTPUT ${stubs}
  COMMAND "${CMAKE_COMMAND}" -E env "PYTHONPATH=${CMAKE_CURRENT_BINARY_DIR}"
    "${Python3_EXECUTABLE}" -m vtkmodules.generate_pyi -p vtkwinding_native -o "${package}"
    ${modules}
  DEPENDS PyvtkFiltersWindingPython PyvtkIOWindingPython
  COMMENT "Writing type stubs")
add_custom_target(winding_type_stubs ALL DEPENDS ${stubs})
install(FILES ${stubs} DESTINATION vtkwinding_native)
