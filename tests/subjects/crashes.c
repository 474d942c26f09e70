/* Follows a null pointer. */
#include <stddef.h>

#include "right.h"

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  const selvage_status status = draw_right(target, clip, vertices, count, texture, options);
  if (status != SELVAGE_OK) return status;
  volatile int* nowhere = NULL;
  *nowhere = 1;
  return status;
}
