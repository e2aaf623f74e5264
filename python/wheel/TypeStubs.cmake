# Type stubs of the wrapped module, by VTK's generator, which imports it with the wheel vtk.
set(stub "${CMAKE_CURRENT_BINARY_DIR}/stubs/vtkFiltersWinding.pyi")
add_custom_command(OUTPUT "${stub}"
  COMMAND "${CMAKE_COMMAND}" -E make_directory "${CMAKE_CURRENT_BINARY_DIR}/stubs/vtkwinding"
  COMMAND "${CMAKE_COMMAND}" -E touch
    "${CMAKE_CURRENT_BINARY_DIR}/stubs/vtkwinding/__init__.py"
  COMMAND "${CMAKE_COMMAND}" -E copy "$<TARGET_FILE:PyvtkFiltersWindingPython>"
    "${CMAKE_CURRENT_BINARY_DIR}/stubs/vtkwinding/"
  COMMAND "${CMAKE_COMMAND}" -E env
    "PYTHONPATH=${CMAKE_CURRENT_BINARY_DIR}/stubs" "${Python3_EXECUTABLE}"
    -m vtkmodules.generate_pyi -p vtkwinding -o "${CMAKE_CURRENT_BINARY_DIR}/stubs"
    vtkFiltersWinding
  DEPENDS PyvtkFiltersWindingPython
  COMMENT "Writing type stubs")
add_custom_target(winding_type_stubs ALL DEPENDS "${stub}")
install(FILES "${stub}" DESTINATION vtkwinding)
