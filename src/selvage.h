/* Selvage: an exact polygon texture mapper. The C interface.
 *
 * Conventions of SELVAGE_PROFILE_EXACT (spec/README.md is the full specification):
 *   target    x right, y down, in pixels; pixel (i, j) is sampled at its centre (i + 1/2, j + 1/2)
 *   texture   u right, v down, in texels; texel (s, t) owns [s, s + 1) x [t, t + 1)
 *   intervals half-open everywhere: a pixel centre on a left or top edge is drawn, on a right or
 *             bottom edge it is not, so polygons that share an edge neither overlap nor leave a gap
 *
 * Include this file; the others of selvage/ are its parts.
 *
 * No function allocates, throws, keeps state or touches a global: calls on different targets may
 * run at the same time. (With more than one thread, selvage_draw_many hands work to oneTBB, which
 * has memory and threads of its own.) How the caller's thread rounds floating-point numbers,
 * whether it flushes those next to 0 and what it traps changes no picture and no vertex, and stays
 * as it was, where the C library knows such modes. (What is flushed is 0: a w below 2^-1022 too.)
 * A call takes up to 96 KB of stack; without vectors and threads of its own 20 KB, or 16 where
 * addresses have 32 bits.
 *
 * Enumerations are int32_t with named values, so that their size is the same in every compiler and
 * an unknown value is an error that can be reported rather than undefined behaviour.
 */
#ifndef SELVAGE_H
#define SELVAGE_H

#include <stddef.h>
#include <stdint.h>

#include "selvage/api.h"
#include "selvage/kernels.h"
#include "selvage/many.h"
#include "selvage/prepare.h"
#include "selvage/status.h"
#include "selvage/types.h"
#include "selvage/vertices.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Draws a texture-mapped polygon.
 *
 * clip      NULL means the whole target; otherwise only pixels inside both are drawn.
 * vertices  in order around the polygon, either winding. The polygon must be y-monotone: every scan
 *           line crosses two edges or none. Convex polygons are. Horizontal edges, repeated
 *           vertices and collinear runs are legal; so are chains that cross.
 * texture   must have the target's format.
 * options   NULL means all zero.
 *
 * No texel may share memory with a pixel, and no vertex with the target's rows or what lies between
 * them: SELVAGE_ERROR_OVERLAP.
 * Texture and target may interleave in one bitmap (two rectangles of an atlas) if their pitches are
 * equal in magnitude; otherwise their address ranges must not meet.
 *
 * Arguments are checked in the order options, target, texture, vertices; the first error found is
 * returned and nothing is drawn. Time is proportional to the vertices, the rows the polygon and the
 * clip share, and the pixels drawn. */
SELVAGE_API selvage_status selvage_draw(const selvage_image* target, const selvage_rect* clip,
                                        const selvage_vertex* vertices, size_t count,
                                        const selvage_texture* texture,
                                        const selvage_options* options);

/* Tells what selvage_draw would draw these arguments by, and draws nothing. The same arguments are
 * checked in the same order, then `choice`. On an error *choice is left as it was.
 *
 * It depends on the vertices, the tolerance, filter and profile, and on the rows that are visible.
 * Where less was measured to cost more, a tolerance changes nothing: what is affine, rows in
 * perspective narrower than 160 px, and those that would be divided more often than every 64 px are
 * drawn exactly; by SELVAGE_KERNEL_AVX512, rows narrower than 256 px, and those that would be
 * divided within the row more often than every 1024 px. All else that is drawn within a tolerance
 * is the same by every kernel, and all of it under every clip. */
SELVAGE_API selvage_status selvage_choose(const selvage_image* target, const selvage_rect* clip,
                                          const selvage_vertex* vertices, size_t count,
                                          const selvage_texture* texture,
                                          const selvage_options* options, selvage_choice* choice);

/* "major.minor.patch" */
SELVAGE_API const char* selvage_version(void);

#ifdef __cplusplus
}
#endif

#endif
