/* Part of selvage.h, which is what to include: which inner loops there are, and which is the
 * fastest. */
#ifndef SELVAGE_KERNELS_H
#define SELVAGE_KERNELS_H

#include <stddef.h>
#include <stdint.h>

#include "selvage/api.h"
#include "selvage/status.h"
#include "selvage/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Whether this build has the kernel and this machine can run it: 1 or 0. */
SELVAGE_API int32_t selvage_has_kernel(selvage_kernel kernel);

/* What is drawn most. */
typedef int32_t selvage_work;
enum {
  SELVAGE_WORK_LARGE = 0,      /* affine maps, over rows of hundreds of pixels */
  SELVAGE_WORK_MESH = 1,       /* affine maps, over triangles of some 50 pixels */
  SELVAGE_WORK_PERSPECTIVE = 2 /* perspective, over rows of hundreds of pixels */
};

/* Finds the kernel that draws such work fastest on this machine, by a clock: the answer is for
 * selvage_options.kernel. To be called once, at the start of a program: it draws a small picture of
 * its own with one kernel after another, again and again, for some milliseconds (1 to 13 on an AMD
 * EPYC). What counts is the shortest time of each, so that whatever else runs disturbs little, and
 * kernels within 1/16 of the shortest are as fast as each other: of these it is the one that
 * SELVAGE_KERNEL_FASTEST would be.
 *
 * filter         SELVAGE_FILTER_AREA is measured where the texture is minified by about 2.
 * format         of target and texture: SELVAGE_RGBA8888 for filters other than nearest.
 * scratch        aligned as max_align_t is; its first SELVAGE_FASTEST_KERNEL_BYTES are overwritten.
 * scratch_bytes  what is there.
 * fastest        lies outside of these bytes.
 *
 * Checked are filter, format, work, scratch, fastest, in this order. On an error nothing is
 * written. */
SELVAGE_API selvage_status selvage_fastest_kernel(selvage_filter filter, selvage_format format,
                                                  selvage_work work, void* scratch,
                                                  size_t scratch_bytes, selvage_kernel* fastest);

enum { SELVAGE_FASTEST_KERNEL_BYTES = 131072 };

#ifdef __cplusplus
}
#endif

#endif
