/* Its outlines are 1/256 px too far to the left. */
#include "right.h"

static const selvage_claims claims = {
    .bytes = sizeof(selvage_claims),
    .lacks = SELVAGE_LACKS_NAMED_ERRORS,
    .most_vertices = 64,
};
SELVAGE_API const selvage_claims* selvage_subject(void) { return &claims; }

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  selvage_vertex moved[64];
  for (size_t i = 0; i < count; ++i) {
    moved[i] = vertices[i];
    if (moved[i].x > SELVAGE_X_MIN) --moved[i].x;
  }
  return draw_right(target, clip, moved, count, texture, options);
}
