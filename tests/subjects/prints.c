/* Talks while it draws. */
#include <stdio.h>

#include "right.h"

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  const selvage_status status = draw_right(target, clip, vertices, count, texture, options);
  if (status != SELVAGE_OK) return status;
  printf("drew %d vertices\n", (int)count);
  fprintf(stderr, "and says so\n");
  return status;
}
