# Which SIMD targets the vector kernels are built for.
set(SELVAGE_KERNELS all CACHE STRING
  "Vector kernels: all; or native: what this machine has of AVX2 and AVX-512, or SSE4 if it has neither")
set_property(CACHE SELVAGE_KERNELS PROPERTY STRINGS all native)

# selvage_kernels_left_out(VARIABLE): Highway's names of those left out, as C++ has them; empty if
# none is.
function(selvage_kernels_left_out variable)
  set(${variable} "" PARENT_SCOPE)
  if(SELVAGE_KERNELS STREQUAL "all")
    return()
  elseif(NOT SELVAGE_KERNELS STREQUAL "native")
    message(FATAL_ERROR "SELVAGE_KERNELS is all or native, not ${SELVAGE_KERNELS}")
  elseif(CMAKE_CROSSCOMPILING OR NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    return()
  endif()
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -march=native -dM -E -x c++ /dev/null
    OUTPUT_VARIABLE macros COMMAND_ERROR_IS_FATAL ANY)
  if(NOT macros MATCHES "__AVX2__ ")
    set(left_out "HWY_AVX2|HWY_AVX3")
  elseif(NOT macros MATCHES "__AVX512BW__ ")
    set(left_out "HWY_SSE4|HWY_AVX3")
  else()
    set(left_out "HWY_SSE4")
  endif()
  message(STATUS "Vector kernels: native ones, which leaves out ${left_out}")
  set(${variable} "${left_out}" PARENT_SCOPE)
endfunction()
