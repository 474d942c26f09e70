/* Has selvage_prepare, and does not tell how much memory that needs. */
#include "right_calls.h"

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  return draw_right(target, clip, vertices, count, texture, options);
}

SELVAGE_API selvage_status selvage_prepare(PREPARE_ARGUMENTS) {
  return prepare_right(source, layout, with_sums, memory, bytes, prepared);
}
