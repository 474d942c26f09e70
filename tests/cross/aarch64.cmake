# Debian's cross compiler for 64-bit ARM, and qemu to run what it makes. SELVAGE_SYSROOT holds the
# libraries that the tests need, as tests/cross/run unpacks them.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(triplet aarch64-linux-gnu)
set(CMAKE_C_COMPILER ${triplet}-gcc)
set(CMAKE_CXX_COMPILER ${triplet}-g++)

# The compiler's checks are given this file too, and need the same libraries.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES SELVAGE_SYSROOT)
if(NOT SELVAGE_SYSROOT)
  message(FATAL_ERROR "SELVAGE_SYSROOT is not set; call tests/cross/run, which makes one")
endif()
set(CMAKE_LIBRARY_ARCHITECTURE ${triplet})
set(CMAKE_FIND_ROOT_PATH ${SELVAGE_SYSROOT} /usr/${triplet})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
# Headers for every architecture, as Highway's, are the machine's own.
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE BOTH)
set(CMAKE_CXX_FLAGS_INIT "-isystem ${SELVAGE_SYSROOT}/usr/include/${triplet}")

# A processor of 2012: whatever newer ones have is an illegal instruction.
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static;-cpu;cortex-a57;-L;/usr/${triplet})
