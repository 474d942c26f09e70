/* Claims what the macro CLAIMS says. */
#include "right.h"

static const selvage_claims claims = {CLAIMS};
SELVAGE_API const selvage_claims* selvage_subject(void) { return &claims; }

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  return draw_right(target, clip, vertices, count, texture, options);
}
