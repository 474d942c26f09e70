/* Part of selvage.h, which is what to include: many polygons in one call. */
#ifndef SELVAGE_MANY_H
#define SELVAGE_MANY_H

#include <stddef.h>
#include <stdint.h>

#include "selvage/api.h"
#include "selvage/status.h"
#include "selvage/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Draws polygons in order: the same bytes as selvage_draw for one after another, whatever the
 * number of threads. The rows are split into bands, which are drawn side by side.
 *
 * polygons       may be NULL if polygon_count is 0.
 * threads        1: the caller's alone. 0: as many as the machine runs at a time. N: at most N, the
 *                caller's among them. In a library built without oneTBB every call is as with 1.
 * scratch        aligned as max_align_t is; its first selvage_draw_many_bytes(polygon_count) bytes
 *                are overwritten. May be NULL if polygon_count is 0.
 * scratch_bytes  what is there.
 * failed         may be NULL. If a polygon is refused, its index is written here; other errors
 * leave it alone.
 *
 * Every polygon is checked before the first is drawn: an error draws nothing at all. Checked are,
 * in this order, options, target, threads, polygons, scratch; then polygon after polygon its
 * texture and its vertices as by selvage_draw. The list of polygons, the textures' descriptors, the
 * vertices and the texels must share no memory with the target (SELVAGE_ERROR_OVERLAP; texels may
 * interleave with it as for selvage_draw), nor any of these with the scratch memory
 * (SELVAGE_ERROR_SCRATCH_OVERLAP). */
SELVAGE_API selvage_status selvage_draw_many(const selvage_image* target, const selvage_rect* clip,
                                             const selvage_polygon* polygons, size_t polygon_count,
                                             const selvage_options* options, int32_t threads,
                                             void* scratch, size_t scratch_bytes, size_t* failed);

/* The scratch memory that so many polygons need, on the order of 100 bytes each and 1000 more. May
 * differ between versions of the library. SIZE_MAX where they are too many: more than
 * 4 * 10^8, or, where addresses have 32 bits, than half of those hold. */
SELVAGE_API size_t selvage_draw_many_bytes(size_t polygon_count);

#ifdef __cplusplus
}
#endif

#endif
