/* Part of selvage.h, which is what to include: vertices, images, options. */
#ifndef SELVAGE_TYPES_H
#define SELVAGE_TYPES_H

#include <stddef.h>
#include <stdint.h>

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
/* No channel is treated otherwise than the others, and none by its meaning: bytes in another order
 * (BGRA) come out in that order. Filters take means of the bytes as they are. So texels that have
 * an alpha want to be premultiplied by it, and sRGB is mixed as it is encoded. */

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
  selvage_kernel kernel; /* 0, or what selvage_fastest_kernel found; others to compare them */
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

#endif
