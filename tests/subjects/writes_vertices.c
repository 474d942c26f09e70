/* Sorts the vertices where they are. */
#include "right.h"

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  const selvage_status status = draw_right(target, clip, vertices, count, texture, options);
  if (status != SELVAGE_OK) return status;
  volatile selvage_vertex* first = (selvage_vertex*)vertices;
  first->x = 0;
  return status;
}
