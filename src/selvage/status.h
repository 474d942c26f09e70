/* Part of selvage.h, which is what to include: every error by its name. */
#ifndef SELVAGE_STATUS_H
#define SELVAGE_STATUS_H

#include <stdint.h>

#include "selvage/api.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Every error leaves the target as it was. selvage_status_text says what would be right. */
typedef int32_t selvage_status;
enum {
  SELVAGE_OK = 0,
  SELVAGE_ERROR_TARGET_NULL,       /* target or target->pixels is NULL */
  SELVAGE_ERROR_TARGET_FORMAT,     /* not a selvage_format */
  SELVAGE_ERROR_TARGET_SIZE,       /* width or height below 1 */
  SELVAGE_ERROR_TARGET_PITCH,      /* |pitch| below a row, no multiple of a pixel, or too large */
  SELVAGE_ERROR_TARGET_ALIGNMENT,  /* pixels is not aligned to a pixel's size */
  SELVAGE_ERROR_TEXTURE_NULL,      /* texture or texture->texels is NULL */
  SELVAGE_ERROR_TEXTURE_FORMAT,    /* not a selvage_format */
  SELVAGE_ERROR_TEXTURE_SIZE,      /* width or height below 1 */
  SELVAGE_ERROR_TEXTURE_LAYOUT,    /* not a selvage_layout */
  SELVAGE_ERROR_TEXTURE_PITCH,     /* as for the target; for tiles as their layout says */
  SELVAGE_ERROR_TEXTURE_ALIGNMENT, /* texels is not aligned to a texel's size, or a tile's */
  SELVAGE_ERROR_TEXTURE_PREPARED,  /* prepared is neither NULL nor as selvage_prepare leaves it */
  SELVAGE_ERROR_FORMAT_MISMATCH,   /* target and texture formats differ */
  SELVAGE_ERROR_OVERLAP,           /* the texture or the vertices share memory with the target */
  SELVAGE_ERROR_VERTICES_NULL,     /* vertices is NULL */
  SELVAGE_ERROR_VERTEX_COUNT,      /* fewer than 3 */
  SELVAGE_ERROR_VERTEX_POSITION,   /* x or y outside [SELVAGE_X_MIN, SELVAGE_X_END) */
  SELVAGE_ERROR_VERTEX_Q,          /* q outside [1, SELVAGE_Q_MAX] */
  SELVAGE_ERROR_NOT_MONOTONE,      /* some scan line crosses more than two edges */
  SELVAGE_ERROR_VERTEX_FRACTION,   /* historic profiles: x or y is no whole pixel */
  SELVAGE_ERROR_VERTEX_Q_DIFFERS,  /* historic profiles: the q are not all equal */
  SELVAGE_ERROR_PROFILE,           /* not a selvage_profile */
  SELVAGE_ERROR_FILTER,            /* not a selvage_filter */
  SELVAGE_ERROR_FILTER_PROFILE,    /* historic profiles: a filter other than nearest */
  SELVAGE_ERROR_FILTER_FORMAT,     /* a filter other than nearest, and not RGBA8888 */
  SELVAGE_ERROR_LAYOUT_PROFILE,    /* historic profiles: a layout other than rows */
  SELVAGE_ERROR_ADDRESS,           /* not a selvage_address */
  SELVAGE_ERROR_TOLERANCE,         /* negative */
  SELVAGE_ERROR_KERNEL,            /* not a selvage_kernel, or not one for this machine */
  SELVAGE_ERROR_THREADS,           /* selvage_draw_many: threads is negative */
  SELVAGE_ERROR_POLYGONS_NULL, /* selvage_draw_many: polygons is NULL and their count is not 0 */
  SELVAGE_ERROR_SCRATCH_NULL,  /* selvage_draw_many: likewise scratch */
  SELVAGE_ERROR_SCRATCH_ALIGNMENT, /* selvage_draw_many: not aligned as max_align_t is */
  SELVAGE_ERROR_SCRATCH_SIZE,      /* selvage_draw_many: below selvage_draw_many_bytes */
  SELVAGE_ERROR_SCRATCH_OVERLAP,   /* selvage_draw_many: what is drawn, or on, lies in it */
  SELVAGE_ERROR_SNAP_NULL,         /* selvage_snap: no vertex to write to */
  SELVAGE_ERROR_SNAP_NOT_FINITE,   /* selvage_snap: a NaN or an infinity */
  SELVAGE_ERROR_SNAP_POSITION,     /* selvage_snap: x or y beyond the accepted range */
  SELVAGE_ERROR_SNAP_TEXTURE,      /* selvage_snap: u or v beyond [-32768, 32768) texels */
  SELVAGE_ERROR_SNAP_W,            /* selvage_snap: w gives a q outside [1, SELVAGE_Q_MAX] */
  SELVAGE_ERROR_FIT_NULL,          /* selvage_fit: no corners, or no vertices to write to */
  SELVAGE_ERROR_FIT_COUNT,         /* selvage_fit: neither 3 nor 4 corners */
  SELVAGE_ERROR_FIT_DOUBLED,       /* selvage_fit: the doubled corner is not one of the three */
  SELVAGE_ERROR_FIT_SIZE,          /* selvage_fit: width or height outside [1, 32767] texels */
  SELVAGE_ERROR_PREPARE_NULL,      /* selvage_prepare: memory or prepared is NULL */
  SELVAGE_ERROR_PREPARE_LAYOUT,    /* selvage_prepare: not a selvage_layout */
  SELVAGE_ERROR_PREPARE_SUMS,      /* selvage_prepare: sums wanted, and not RGBA8888 */
  SELVAGE_ERROR_PREPARE_ALIGNMENT, /* selvage_prepare: memory is no multiple of
                                      SELVAGE_PREPARED_ALIGNMENT */
  SELVAGE_ERROR_PREPARE_SIZE,      /* selvage_prepare: bytes is below selvage_prepare_bytes */
  SELVAGE_ERROR_PREPARE_OVERLAP,   /* selvage_prepare: memory shares bytes with the source, its
                                      descriptor or *prepared */
  SELVAGE_ERROR_CHOICE_NULL,       /* selvage_choose: no choice to write to */
  SELVAGE_ERROR_MEASURE_WORK,      /* selvage_fastest_kernel: not a selvage_work */
  SELVAGE_ERROR_MEASURE_NULL,      /* selvage_fastest_kernel: scratch or fastest is NULL */
  SELVAGE_ERROR_MEASURE_ALIGNMENT, /* selvage_fastest_kernel: scratch is not aligned as max_align_t
                                      is */
  SELVAGE_ERROR_MEASURE_SIZE,      /* selvage_fastest_kernel: below SELVAGE_FASTEST_KERNEL_BYTES */
  SELVAGE_ERROR_MEASURE_OVERLAP,   /* selvage_fastest_kernel: fastest lies in the scratch memory */
  SELVAGE_STATUS_COUNT
};

/* One sentence: what was wrong and what would be right. Never NULL; a value that is no
 * selvage_status gives "unknown status". */
SELVAGE_API const char* selvage_status_text(selvage_status status);

#ifdef __cplusplus
}
#endif

#endif
