# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause

foreach(component IN LISTS Winding_FIND_COMPONENTS)
  if(Winding_FIND_REQUIRED_${component})
    set(Winding_FOUND FALSE)
    set(Winding_NOT_FOUND_MESSAGE "it has no components, and one is asked for: ${component}")
    return()
  endif()
endforeach()

include("${CMAKE_CURRENT_LIST_DIR}/WindingTargets.cmake")
