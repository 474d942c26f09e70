/* Calls itself until the stack is full. */
#include "right.h"

static volatile int depth_limit = 1 << 30;

static int deepen(int depth) {
  volatile char frame[4096];
  frame[0] = (char)depth;
  return depth >= depth_limit ? 0 : deepen(depth + 1) + frame[0];
}

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  const selvage_status status = draw_right(target, clip, vertices, count, texture, options);
  if (status != SELVAGE_OK) return status;
  return (selvage_status)deepen(status);
  return status;
}
