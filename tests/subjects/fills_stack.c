/* Has a variable that is larger than the stack, and less than what no mapping is below it. */
#include "right.h"

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  volatile char frame[(size_t)1 << 26];
  for (size_t end = sizeof frame; end > 0; end -= 4096) frame[end - 1] = (char)count;
  const selvage_status status = draw_right(target, clip, vertices, count, texture, options);
  return status == SELVAGE_OK ? frame[4095] - (char)count : status;
}
