# 32-bit ARM, with double precision and without NEON's vectors: addresses, size_t and long of 32 bits,
# and no integer of 128.
set(CMAKE_SYSTEM_PROCESSOR armv7l)
set(triplet arm-linux-gnueabihf)
set(emulator qemu-arm-static -cpu cortex-a7)
include(${CMAKE_CURRENT_LIST_DIR}/debian.cmake)
