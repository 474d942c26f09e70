# 64-bit ARM. A processor of 2012: whatever newer ones have is an illegal instruction.
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(triplet aarch64-linux-gnu)
set(emulator qemu-aarch64-static -cpu cortex-a57)
include(${CMAKE_CURRENT_LIST_DIR}/debian.cmake)
