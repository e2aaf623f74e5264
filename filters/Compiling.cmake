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
