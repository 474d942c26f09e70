/* Reads what is behind the last texel. */
#include "right.h"

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  const selvage_status status = draw_right(target, clip, vertices, count, texture, options);
  if (status != SELVAGE_OK) return status;
  const selvage_image image = {(void*)texture->texels, texture->width, texture->height,
                               texture->pitch, texture->format};
  volatile char behind = *end_byte(&image);
  (void)behind;
  return status;
}
