/* Draws right, and prepares textures as the macro WRONG has it. */
#include "right_calls.h"

#define RIGHT 0
#define SPOILED 1   /* one texel of tiles is another's */
#define ELSEWHERE 2 /* hands on the source itself */
#define PAST_END 3  /* writes the byte behind its memory */
#define SOURCE 4    /* writes to the source */
#define TOO_MUCH 5  /* wants more memory than there is */
#define LATER 6     /* writes to what it prepared when it draws */
#define NO_TILES 7  /* says that tiles are beyond it */

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  if (WRONG == LATER && texture != NULL && texture->layout == SELVAGE_LAYOUT_TILES) {
    *(volatile char*)texture->texels = 1;
  }
  return draw_right(target, clip, vertices, count, texture, options);
}

SELVAGE_API size_t selvage_prepare_bytes(const selvage_texture* source, selvage_layout layout,
                                         int32_t with_sums) {
  if (WRONG == TOO_MUCH) return (size_t)1 << 40;
  return prepare_bytes_right(source, layout, with_sums);
}

SELVAGE_API selvage_status selvage_prepare(PREPARE_ARGUMENTS) {
  if (WRONG == NO_TILES && layout == SELVAGE_LAYOUT_TILES) return SELVAGE_STATUS_BEYOND_CLAIMS;
  const selvage_status status = prepare_right(source, layout, with_sums, memory, bytes, prepared);
  if (status != SELVAGE_OK) return status;
  if (WRONG == SPOILED && layout == SELVAGE_LAYOUT_TILES) *(char*)memory ^= 1;
  if (WRONG == ELSEWHERE) *prepared = *source;
  if (WRONG == PAST_END) ((volatile char*)memory)[bytes] = 1;
  if (WRONG == SOURCE) *(volatile char*)source->texels = 1;
  return status;
}
