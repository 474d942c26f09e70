/* Crashes while it is loaded. */
#include <stdlib.h>

#include "right.h"

__attribute__((constructor)) static void begin(void) { abort(); }

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  return draw_right(target, clip, vertices, count, texture, options);
}
