/* Part of selvage.h, which is what to include: textures laid out for drawing. */
#ifndef SELVAGE_PREPARE_H
#define SELVAGE_PREPARE_H

#include <stddef.h>
#include <stdint.h>

#include "selvage/api.h"
#include "selvage/status.h"
#include "selvage/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Copies a texture into the caller's memory, so laid out that drawing from it is fast. The picture
 * is the same, byte for byte, whatever the layout.
 *
 * Rows at a pitch that is a large power of two are slow to walk down: the texels of a column fall
 * into few places of a cache, and push each other out. SELVAGE_LAYOUT_ROWS copies to rows at a
 * better pitch. SELVAGE_LAYOUT_TILES has texels of one column in one cache line too: it minds the
 * direction of a walk least, and is a little slower than rows where u runs along x.
 * With sums, SELVAGE_FILTER_AREA looks up large boxes of texels instead of visiting them: its time
 * no longer grows with the scale. They take 16 bytes a texel.
 *
 * source     any texture that selvage_draw takes; its texels are copied, not its sums.
 * with_sums  0, or not 0: with sums, which are for RGBA8888.
 * memory     at a multiple of SELVAGE_PREPARED_ALIGNMENT. It stays the caller's, and must stay as
 *            it is while *prepared is drawn from.
 * bytes      at least selvage_prepare_bytes. What is beyond them, or between texels, is not
 *            written.
 * prepared   the texture to draw from. May be the same as source.
 *
 * Checked are source, layout, with_sums, memory, in this order. On an error nothing is written. */
SELVAGE_API selvage_status selvage_prepare(const selvage_texture* source, selvage_layout layout,
                                           int32_t with_sums, void* memory, size_t bytes,
                                           selvage_texture* prepared);

enum { SELVAGE_PREPARED_ALIGNMENT = 64 }; /* bytes */

/* The memory that selvage_prepare needs, a multiple of SELVAGE_PREPARED_ALIGNMENT, as C11's
 * aligned_alloc wants it. SIZE_MAX where it would refuse whatever the memory, or
 * where none is large enough. May differ between versions of the library. */
SELVAGE_API size_t selvage_prepare_bytes(const selvage_texture* source, selvage_layout layout,
                                         int32_t with_sums);

#ifdef __cplusplus
}
#endif

#endif
