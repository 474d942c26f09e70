/* Selvage: an exact polygon texture mapper. The C interface.
 *
 * Conventions of SELVAGE_PROFILE_EXACT (spec/README.md is the full specification):
 *   target    x right, y down, in pixels; pixel (i, j) is sampled at its centre (i + 1/2, j + 1/2)
 *   texture   u right, v down, in texels; texel (s, t) owns [s, s + 1) x [t, t + 1)
 *   intervals half-open everywhere: a pixel centre on a left or top edge is drawn, on a right or
 *             bottom edge it is not, so polygons that share an edge neither overlap nor leave a gap
 *
 * No function allocates, throws, keeps state or touches a global: calls on different targets may
 * run at the same time. (With more than one thread, selvage_draw_many hands work to oneTBB, which
 * has memory and threads of its own.)
 *
 * Enumerations are int32_t with named values, so that their size is the same in every compiler and
 * an unknown value is an error that can be reported rather than undefined behaviour.
 */
#ifndef SELVAGE_H
#define SELVAGE_H

#include <stddef.h>
#include <stdint.h>

#if defined(SELVAGE_SHARED) && defined(_WIN32)
#define SELVAGE_API __declspec(dllimport)
#elif defined(__GNUC__)
#define SELVAGE_API __attribute__((visibility("default")))
#else
#define SELVAGE_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Vertices ------------------------------------------------------------------------------ */

enum {
  SELVAGE_SUBPIXELS = 256,   /* units of x, y in a pixel */
  SELVAGE_SUBTEXELS = 65536, /* units of u, v in a texel */
  SELVAGE_Q_MAX = 16777216,  /* 2^24 */
  SELVAGE_X_MIN = -8388608,  /* x, y lie in [SELVAGE_X_MIN, SELVAGE_X_END), */
  SELVAGE_X_END = 8388608    /* that is [-32768, 32768) px */
};

typedef struct selvage_vertex {
  int32_t x, y; /* 1/256 px, in [SELVAGE_X_MIN, SELVAGE_X_END) */
  int32_t u, v; /* 1/65536 texel, any value: [-32768, 32768) texels */
  int32_t q;    /* 1/w on any scale common to the polygon, in [1, 2^24]; all equal means affine */
} selvage_vertex;

/* ---- Images -------------------------------------------------------------------------------- */

typedef int32_t selvage_format;
enum {
  SELVAGE_INDEX8 = 0,  /* uint8_t: an index or a grey level */
  SELVAGE_RGB565 = 1,  /* uint16_t: red in the high 5 bits, then green 6, blue 5 */
  SELVAGE_RGBA8888 = 2 /* four bytes in memory order: red, green, blue, alpha */
};

/* Pixel (i, j) is at (char*)pixels + j * pitch + i * (bytes per pixel). A negative pitch is a
 * picture stored bottom row first: `pixels` then points at the row that is drawn on top.
 * width and height are at least 1; |pitch| is at least a row; pixels and pitch are multiples of
 * the bytes per pixel; the whole image spans at most PTRDIFF_MAX bytes. */
typedef struct selvage_image {
  void* pixels;
  int32_t width, height; /* px */
  ptrdiff_t pitch;       /* bytes from a row to the next one down */
  selvage_format format;
} selvage_image;

typedef int32_t selvage_layout;
enum {
  SELVAGE_LAYOUT_ROWS = 0, /* plain rows, as in selvage_image */
  SELVAGE_LAYOUT_TILES = 1 /* tiles of 4 x 4 texels: the 16 of a tile follow each other row by row,
                              the tiles of a row of tiles too; pitch is from a row of tiles to the
                              next one down. Texels and pitch are multiples of a tile, the pitch is
                              positive and at least a row of tiles: as many as hold width texels,
                              and as many rows of them as hold height. Texels that a tile has
                              beyond width or height are never read. */
};

typedef struct selvage_texture {
  const void* texels;
  int32_t width, height; /* texels */
  ptrdiff_t pitch;       /* bytes */
  selvage_format format;
  selvage_layout layout;
  const void* prepared; /* NULL, or the sums that selvage_prepare put behind the texels */
} selvage_texture;

/* One of many that are drawn in one call. */
typedef struct selvage_polygon {
  const selvage_vertex* vertices;
  size_t count; /* of the vertices */
  const selvage_texture* texture;
} selvage_polygon;

/* Half-open: columns [left, right), rows [top, bottom), px. Empty where left >= right or
 * top >= bottom, which is legal and draws nothing. May reach beyond the target. */
typedef struct selvage_rect {
  int32_t left, top, right, bottom;
} selvage_rect;

/* ---- Options: all zero is exact, nearest, clamp ---------------------------------------------- */

/* The conventions that are drawn by; spec/README.md has each in full. The historic ones want whole
 * pixels for x and y and all q equal, and have arithmetic of their own: tolerance is nothing to
 * them. */
typedef int32_t selvage_profile;
enum {
  SELVAGE_PROFILE_EXACT = 0,    /* as above: the profile to draw with */
  SELVAGE_PROFILE_ABRASH56 = 1, /* two-stage 16.16 DDA of 1992: pixels sampled at whole positions,
                                   half-open; texels floor(u); polygons clockwise on the screen,
                                   the other winding draws nothing */
  SELVAGE_PROFILE_ABRASH57 = 2, /* its sequel: source prestepped by half a step, texel centres at
                                   whole u: floor(u + 1/2). A texture W texels wide goes from u = 0
                                   to W - 1 there */
  SELVAGE_PROFILE_DKIT = 3 /* the classroom scan-line mapper: edges and texels rounded, both ends
                              of a span and of a polygon drawn, either winding */
};

typedef int32_t selvage_filter;
enum {
  SELVAGE_FILTER_NEAREST = 0, /* the texel that holds (u, v): (floor u, floor v) */
  /* The others mix texels, each of the four channels by itself, in integers that spec/README.md
   * gives; halves are rounded up. They need RGBA8888 and SELVAGE_PROFILE_EXACT. */
  SELVAGE_FILTER_FOUR = 1,     /* the mean of the four texels around (u, v) */
  SELVAGE_FILTER_BILINEAR = 2, /* these four, weighed by the distance in steps of 1/256 texel */
  SELVAGE_FILTER_AREA = 3      /* the mean of a box as large as a pixel is in the texture, and at
                                  least a texel: bilinear where nothing is minified. Time is then
                                  proportional to the texels of the texture under the boxes,
                                  unless the texture has sums (selvage_prepare) */
};

typedef int32_t selvage_address;
enum {
  SELVAGE_ADDRESS_CLAMP = 0, /* texels beyond the edge repeat the edge's texel */
  SELVAGE_ADDRESS_WRAP = 1 /* the texture repeats: s mod width, in [0, width) for negative s too */
};

/* Which of the mapper's inner loops draw. They differ in speed, not by a bit in what they draw. */
typedef int32_t selvage_kernel;
enum {
  SELVAGE_KERNEL_FASTEST = 0, /* of those that the machine can run */
  SELVAGE_KERNEL_SCALAR = 1,
  SELVAGE_KERNEL_SSE4 = 2,
  SELVAGE_KERNEL_AVX2 = 3,
  SELVAGE_KERNEL_AVX512 = 4,
  SELVAGE_KERNEL_NEON = 5
};

typedef struct selvage_options {
  selvage_profile profile;
  selvage_filter filter;
  selvage_address address;
  int32_t tolerance; /* largest error in u and in v accepted, 1/65536 texel, >= 0: a pixel may show
                        the texel of any (u, v) so near to its own. 0 is exact. Which pixels are
                        drawn stays exact. Only nearest in SELVAGE_PROFILE_EXACT makes use of it */
  selvage_kernel kernel; /* for tests and measurements */
} selvage_options;

/* ---- What is drawn by ------------------------------------------------------------------------ */

/* Later ones cost more where several would do. A bound is derived from the polygon's own numbers
 * (spec/README.md), and kept by every pixel; the first and those that say so are exact. */
typedef int32_t selvage_method;
enum {
  SELVAGE_METHOD_NONE = 0, /* no pixel is drawn */
  SELVAGE_METHOD_COPY = 1, /* exact: texel centres on pixel centres, rows are copied */
  SELVAGE_METHOD_AFFINE_FOR_PERSPECTIVE = 2, /* u and v straight from end to end of a row */
  SELVAGE_METHOD_SUBDIVIDED = 3,   /* u and v divided every segment_px pixels, straight between */
  SELVAGE_METHOD_EXACT_AFFINE = 4, /* exact, whatever the tolerance: it costs no more */
  SELVAGE_METHOD_EXACT_PERSPECTIVE = 5, /* exact: a division a pixel */
  SELVAGE_METHOD_FILTER = 6,            /* exact: a filter other than nearest */
  SELVAGE_METHOD_HISTORIC = 7           /* by the profile's own arithmetic */
};

/* Rows of pixels in perspective are chosen for one by one, each by its own two edges: method is
 * then the last of the above that some row is drawn by, segment_px the shortest, bound the
 * greatest. A clip one row high tells a row's own. */
typedef struct selvage_choice {
  selvage_method method;
  int32_t segment_px; /* a multiple of 16; 0 where no row is SELVAGE_METHOD_SUBDIVIDED */
  int32_t bound;      /* 1/65536 texel, at most the tolerance; 0 where all is exact */
} selvage_choice;

/* ---- Status -------------------------------------------------------------------------------- */

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
  SELVAGE_STATUS_COUNT
};

/* ---- Functions ----------------------------------------------------------------------------- */

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
 * It depends on the vertices, the tolerance, filter and profile, and on the rows that are visible:
 * not on the kernel. What is drawn within a tolerance is the same by every kernel and under every
 * clip, as what is drawn exactly. */
SELVAGE_API selvage_status selvage_choose(const selvage_image* target, const selvage_rect* clip,
                                          const selvage_vertex* vertices, size_t count,
                                          const selvage_texture* texture,
                                          const selvage_options* options, selvage_choice* choice);

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

/* The memory that selvage_prepare needs. SIZE_MAX where it would refuse whatever the memory, or
 * where none is large enough. May differ between versions of the library. */
SELVAGE_API size_t selvage_prepare_bytes(const selvage_texture* source, selvage_layout layout,
                                         int32_t with_sums);

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

/* The scratch memory that so many polygons need, on the order of 100 bytes each. May differ between
 * versions of the library. SIZE_MAX where they are too many: more than 4 * 10^8. */
SELVAGE_API size_t selvage_draw_many_bytes(size_t polygon_count);

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
 *          (width, height) and (width, 0), in this order. Or 3: corner `doubled`, 0 .. 2, is taken
 *          twice, so that two corners of the texture meet in it. x, y and q are kept.
 * doubled  not looked at where there are 4 corners
 * fitted   4 vertices for selvage_draw; may be `corners` itself
 *
 * On an error nothing is written. */
SELVAGE_API selvage_status selvage_fit(const selvage_vertex* corners, size_t count, size_t doubled,
                                       int32_t width_texel, int32_t height_texel,
                                       selvage_vertex fitted[4]);

/* One sentence: what was wrong and what would be right. Never NULL; a value that is no
 * selvage_status gives "unknown status". */
SELVAGE_API const char* selvage_status_text(selvage_status status);

/* Whether this build has the kernel and this machine can run it: 1 or 0. */
SELVAGE_API int32_t selvage_has_kernel(selvage_kernel kernel);

/* "major.minor.patch" */
SELVAGE_API const char* selvage_version(void);

#ifdef __cplusplus
}
#endif

#endif
