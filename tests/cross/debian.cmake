# A cross compiler of Debian's, and qemu to run what it makes. SELVAGE_SYSROOT holds the libraries
# that the tests need, as tests/cross/run unpacks them. To be included with `triplet` and `emulator` set.
set(CMAKE_SYSTEM_NAME Linux)
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

set(CMAKE_CROSSCOMPILING_EMULATOR ${emulator} -L /usr/${triplet})
