/* Its u is off by OFF / 65536 texel, and it claims ACCURACY. */
#include "right.h"

static const selvage_claims claims = {
    .bytes = sizeof(selvage_claims),
    .lacks = SELVAGE_LACKS_NAMED_ERRORS,
    .most_vertices = 64,
    .accuracy = ACCURACY,
};
SELVAGE_API const selvage_claims* selvage_subject(void) { return &claims; }

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  selvage_vertex moved[64];
  for (size_t i = 0; i < count; ++i) {
    moved[i] = vertices[i];
    if (moved[i].u <= INT32_MAX - OFF) moved[i].u += OFF;
  }
  return draw_right(target, clip, moved, count, texture, options);
}
