/* Draws right and answers errors (ALWAYS), or refuses every seventh call and draws nothing. */
#include "right.h"

enum { ALWAYS, AT_TIMES };

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  static int calls = 0;
  if (WHEN == AT_TIMES && ++calls % 7 == 0) return SELVAGE_ERROR_TARGET_SIZE;
  const selvage_status status = draw_right(target, clip, vertices, count, texture, options);
  return WHEN == ALWAYS && status == SELVAGE_OK ? SELVAGE_ERROR_TARGET_SIZE : status;
}
