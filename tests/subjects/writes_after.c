/* Writes a byte behind the last pixel. */
#include "right.h"

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  const selvage_status status = draw_right(target, clip, vertices, count, texture, options);
  if (status != SELVAGE_OK) return status;
  *(volatile char*)end_byte(target) = 1;
  return status;
}
