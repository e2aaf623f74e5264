# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause

# Sets winding_structs to the line of _built.py that holds the structs of winding.h.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(winding_header "${PROJECT_SOURCE_DIR}/filters/c/winding.h")
execute_process(
  COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_LIST_DIR}/header.py" "${winding_header}"
  OUTPUT_VARIABLE winding_structs
  COMMAND_ERROR_IS_FATAL ANY)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${winding_header}")
