/* Draws clockwise outlines alone, and says so. */
#include "right.h"

static const selvage_rect nothing = {0, 0, 0, 0};

#ifdef SAYS_SO
static const selvage_claims claims = {
    .bytes = sizeof(selvage_claims), .name = "clockwise", .winding = SELVAGE_WINDING_CLOCKWISE};
SELVAGE_API const selvage_claims* selvage_subject(void) { return &claims; }
#endif

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  int64_t area = 0; /* doubled, positive where the outline is clockwise on the screen */
  for (size_t i = 0; vertices != NULL && i < count; ++i) {
    const selvage_vertex *a = &vertices[i], *b = &vertices[(i + 1) % count];
    area += (int64_t)a->x * b->y - (int64_t)b->x * a->y;
  }
  const selvage_status status = draw_right(target, &nothing, vertices, count, texture, options);
  if (status != SELVAGE_OK || area < 0) return status;
  return draw_right(target, clip, vertices, count, texture, options);
}
