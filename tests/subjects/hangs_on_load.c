/* Never finishes to be loaded. */
#include <stddef.h>

#include "right.h"

__attribute__((constructor)) static void begin(void) {
  for (volatile int i = 0;; ++i) {
  }
}

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  return draw_right(target, clip, vertices, count, texture, options);
}
