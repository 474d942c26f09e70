/* Takes 0.3 s of a processor for a call. */
#include <time.h>

#include "right.h"

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  const clock_t end = clock() + 3 * CLOCKS_PER_SEC / 10;
  while (clock() < end) {
  }
  return draw_right(target, clip, vertices, count, texture, options);
}
