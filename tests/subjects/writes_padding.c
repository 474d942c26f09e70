/* Writes between the end of a row and the next one. */
#include "right.h"

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  const selvage_status status = draw_right(target, clip, vertices, count, texture, options);
  if (status != SELVAGE_OK) return status;
  if (target->pitch > target->width * pixel_bytes(target->format) && target->height > 1) {
    ((char*)target->pixels)[target->width * pixel_bytes(target->format)] ^= 1;
  }
  return status;
}
