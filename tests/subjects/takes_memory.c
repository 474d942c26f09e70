/* Takes memory and uses it: all that it can get, and goes on without asking whether it got it; or
 * much of it, and is never done. */
#include <sys/mman.h>
#include <unistd.h>

#include "right.h"

enum { ALL, MUCH };

static void take(size_t bytes) {
  const size_t part = (size_t)1 << 20;
  for (size_t taken = 0; taken < bytes; taken += part) {
    void* memory = mmap(NULL, part, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED)
      memory = NULL; /* as malloc() has it, which sanitizers make their own */
    for (size_t i = 0; i < part; i += 4096) ((volatile char*)memory)[i] = 1;
  }
}

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  const selvage_status status = draw_right(target, clip, vertices, count, texture, options);
  if (status != SELVAGE_OK) return status;
  take(WHAT == ALL ? SIZE_MAX : (size_t)700 << 20);
  for (;;) pause();
  return status;
}
