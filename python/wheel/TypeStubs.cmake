# Type stubs of the wrapped module, by VTK's generator. It imports the module from the build tree;
# the libraries of the wheel vtk have to be there before the module finds those of the SDK.
set(package "${CMAKE_CURRENT_BINARY_DIR}/vtkwinding")
set(stub "${package}/vtkFiltersWinding.pyi")
configure_file(../vtkwinding/_vtk.py "${package}/_vtk.py" COPYONLY)
configure_file(../_built.py.in "${package}/_built.py" @ONLY)
file(WRITE "${package}/__init__.py" "from . import _vtk\n\n_vtk.load()\n")
add_custom_command(OUTPUT "${stub}"
  COMMAND "${CMAKE_COMMAND}" -E env "PYTHONPATH=${CMAKE_CURRENT_BINARY_DIR}"
    "${Python3_EXECUTABLE}" -m vtkmodules.generate_pyi -p vtkwinding -o "${package}"
    vtkFiltersWinding
  DEPENDS PyvtkFiltersWindingPython
  COMMENT "Writing type stubs")
add_custom_target(winding_type_stubs ALL DEPENDS "${stub}")
install(FILES "${stub}" DESTINATION vtkwinding)
