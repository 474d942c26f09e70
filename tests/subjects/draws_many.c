/* Draws right, and many polygons as the macro WRONG has it. */
#include "right_calls.h"

#define RIGHT 0
#define BACKWARD 1      /* the last polygon first */
#define PAST_SCRATCH 2  /* writes the byte behind the scratch memory */
#define POLYGONS_BACK 3 /* writes to the list of polygons */
#define THREADS 4       /* leaves the last polygon to a thread that never starts */
#define PAST_TEXELS 5   /* reads the byte behind the last texel of the last polygon's texture */

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  return draw_right(target, clip, vertices, count, texture, options);
}

SELVAGE_API size_t selvage_draw_many_bytes(size_t polygon_count) {
  return draw_many_bytes_right(polygon_count);
}

SELVAGE_API selvage_status selvage_draw_many(MANY_ARGUMENTS) {
  if (WRONG == BACKWARD) {
    selvage_status status = SELVAGE_OK;
    for (size_t i = polygon_count; i-- > 0 && status == SELVAGE_OK;) {
      const selvage_polygon* p = &polygons[i];
      status = draw_right(target, clip, p->vertices, p->count, p->texture, options);
    }
    return status;
  }
  if (WRONG == PAST_SCRATCH) ((volatile char*)scratch)[scratch_bytes] = 1;
  if (WRONG == POLYGONS_BACK) ((volatile selvage_polygon*)polygons)[0].count = 3;
  if (WRONG == PAST_TEXELS) {
    const selvage_texture* texture = polygons[polygon_count - 1].texture;
    const selvage_image image = {(void*)texture->texels, texture->width, texture->height,
                                 texture->pitch, texture->format};
    volatile char behind = *end_byte(&image);
    (void)behind;
  }
  if (WRONG == THREADS && threads > 1) --polygon_count;
  return draw_many_right(target, clip, polygons, polygon_count, options, threads, scratch,
                         scratch_bytes, failed);
}
