/* Part of selvage.h, which is what to include: vertices from real numbers and from textures. */
#ifndef SELVAGE_VERTICES_H
#define SELVAGE_VERTICES_H

#include <stddef.h>
#include <stdint.h>

#include "selvage/api.h"
#include "selvage/status.h"
#include "selvage/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Rounds to the nearest vertex of the grid, halves upward.
 *
 * x_px, y_px        px
 * u_texel, v_texel  texels
 * w, w_near         distance along the view axis, and the least w of everything that is drawn
 *                   together: q = 2^24 w_near / w. Polygons that share an edge must share w_near.
 *                   Equal w and w_near (1 and 1) for an affine map.
 *
 * On an error *vertex is left as it was. */
SELVAGE_API selvage_status selvage_snap(double x_px, double y_px, double u_texel, double v_texel,
                                        double w, double w_near, selvage_vertex* vertex);

/* Parameterised mapping: the whole texture onto a polygon, for profiles in which it is as wide as
 * it has texels (all but SELVAGE_PROFILE_ABRASH57).
 *
 * corners  4, in order around a quadrilateral: they get the texture's corners (0, 0), (0, height),
 *          (width, height) and (width, 0), in this order, which is anticlockwise on the screen: top
 *          left, bottom left, bottom right, top right is a picture as it is. Clockwise corners get
 *          the picture transposed. Or 3: corner `doubled`, 0 .. 2, is taken twice, so that two
 *          corners of the texture meet in it. x, y and q are kept.
 * doubled  not looked at where there are 4 corners
 * fitted   4 vertices for selvage_draw; may be `corners` itself
 *
 * On an error nothing is written. */
SELVAGE_API selvage_status selvage_fit(const selvage_vertex* corners, size_t count, size_t doubled,
                                       int32_t width_texel, int32_t height_texel,
                                       selvage_vertex fitted[4]);

#ifdef __cplusplus
}
#endif

#endif
