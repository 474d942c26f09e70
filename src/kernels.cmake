# Which SIMD targets the vector kernels are built for.
# native and best are for x86-64: what this machine has of AVX2 and AVX-512, or SSE4 if it has
# neither; and AVX-512 alone if it has that.
set(SELVAGE_KERNELS all CACHE STRING "Vector kernels: all, this machine's native ones, or its best")
set_property(CACHE SELVAGE_KERNELS PROPERTY STRINGS all native best)

# selvage_has_all(MACROS VARIABLE FEATURE...): whether the compiler defines a macro for each.
function(selvage_has_all macros variable)
  set(${variable} ON PARENT_SCOPE)
  foreach(feature IN LISTS ARGN)
    if(NOT macros MATCHES "__${feature}__ ")
      set(${variable} OFF PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

# selvage_kernels_left_out(VARIABLE): Highway's names of those left out, as C++ has them; empty if
# none is.
function(selvage_kernels_left_out variable)
  set(${variable} "" PARENT_SCOPE)
  if(SELVAGE_KERNELS STREQUAL "all")
    message(STATUS "Vector kernels: all that this processor's family may have")
    return()
  elseif(NOT SELVAGE_KERNELS MATCHES "^(native|best)$")
    message(FATAL_ERROR "SELVAGE_KERNELS is all, native or best, not ${SELVAGE_KERNELS}")
  elseif(CMAKE_CROSSCOMPILING OR NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    return()
  endif()
  separate_arguments(launched UNIX_COMMAND "${CMAKE_CXX_COMPILER_ARG1}")
  execute_process(
    COMMAND ${CMAKE_CXX_COMPILER} ${launched} -march=native -dM -E -x c++ /dev/null
    OUTPUT_VARIABLE macros COMMAND_ERROR_IS_FATAL ANY)
  # What mapper/vector/kernel.cpp asks of the machine.
  selvage_has_all("${macros}" has_avx2 AVX2 FMA BMI2 F16C)
  selvage_has_all("${macros}" has_avx512 AVX512F AVX512VL AVX512DQ AVX512BW BMI2)
  set(left_out)
  if(has_avx2 OR has_avx512)
    list(APPEND left_out HWY_SSE4)
  endif()
  if(NOT has_avx2 OR (has_avx512 AND SELVAGE_KERNELS STREQUAL "best"))
    list(APPEND left_out HWY_AVX2)
  endif()
  if(NOT has_avx512)
    list(APPEND left_out HWY_AVX3)
  endif()
  list(JOIN left_out "|" left_out)
  message(STATUS "Vector kernels: ${SELVAGE_KERNELS}, which leaves out ${left_out}")
  set(${variable} "${left_out}" PARENT_SCOPE)
endfunction()
