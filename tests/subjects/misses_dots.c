/* Draws no quadrilateral on a target of a single pixel, which few cases have and most shrunk ones.
 */
#include "right.h"

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  if (target && target->width == 1 && target->height == 1 && count == 4) return SELVAGE_OK;
  return draw_right(target, clip, vertices, count, texture, options);
}
