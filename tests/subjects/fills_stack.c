/* Has a variable that is far larger than any stack. */
#include "right.h"

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  volatile char frame[(size_t)1 << 30];
  frame[0] = (char)count;
  frame[target == NULL ? 1 : 2] = 1;
  const selvage_status status = draw_right(target, clip, vertices, count, texture, options);
  return status == SELVAGE_OK ? frame[0] - (char)count : status;
}
