/* What a library may export beside selvage_draw, so that `selvage verify --subject` knows what it
 * promises. Without it the library is held to all of SELVAGE_PROFILE_EXACT.
 *
 *   static const selvage_claims claims = {
 *       .bytes = sizeof(selvage_claims), .name = "mine", .version = "1.0",
 *       .filters = 1u << SELVAGE_FILTER_NEAREST,
 *       .lacks = SELVAGE_LACKS_PERSPECTIVE};
 *   SELVAGE_API const selvage_claims* selvage_subject(void) { return &claims; }
 *
 * A field that is zero claims everything there is.
 *
 * What else of selvage.h the library exports is held against the laws, too: selvage_draw_many and
 * selvage_draw_many_bytes, selvage_prepare and selvage_prepare_bytes (law SAME), selvage_choose
 * (law TOLERANCE). The verdict names those that it does not.
 */
#ifndef SELVAGE_SUBJECT_H
#define SELVAGE_SUBJECT_H

#include "selvage.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Which outlines are drawn, as they run on the screen, y down. */
typedef int32_t selvage_winding;
enum {
  SELVAGE_WINDING_BOTH = 0,
  SELVAGE_WINDING_CLOCKWISE = 1, /* the other way round says nothing: it is not asked for */
  SELVAGE_WINDING_COUNTER_CLOCKWISE = 2
};

/* What is not drawn, as a sum. */
enum {
  SELVAGE_LACKS_PERSPECTIVE = 1,       /* q that differ */
  SELVAGE_LACKS_CLIP = 2,              /* a clip rectangle: clip is NULL */
  SELVAGE_LACKS_NEGATIVE_PITCH = 4,    /* pictures stored bottom row first */
  SELVAGE_LACKS_CONCAVE = 8,           /* outlines that are not convex */
  SELVAGE_LACKS_NAMED_ERRORS = 16,     /* bad arguments: none are given */
  SELVAGE_LACKS_ANY_TEXTURE_SIDE = 32, /* textures whose sides are no powers of two */
  SELVAGE_LACKS_OUTSIDE_TEXELS = 64,   /* vertices whose u, v lie beyond [0, width] x [0, height] */
  SELVAGE_LACKS_OUTSIDE_VERTICES = 128, /* vertices beyond [0, width] x [0, height] of the target */
  SELVAGE_LACKS_ALL = 255
};

/* What a call may answer, drawing nothing, where it is beyond the subject in a way that no field
 * tells: selvage_prepare, say, of a layout that it does not have. It counts as not claimed, and the
 * verdict shows how often it was said. */
enum { SELVAGE_STATUS_BEYOND_CLAIMS = -1 };

typedef struct selvage_claims {
  size_t bytes;            /* sizeof(selvage_claims): later versions have more fields behind */
  const char* name;        /* of the mapper; NULL: that of the library's file */
  const char* version;     /* its own; may be NULL */
  selvage_profile profile; /* the one that it is held to */
  selvage_winding winding;
  uint32_t formats;        /* sum of 1u << SELVAGE_RGBA8888, ...; 0: all */
  uint32_t filters;        /* sum of 1u << SELVAGE_FILTER_NEAREST, ..., which must be in it; 0: all.
                              Others must get SELVAGE_ERROR_FILTER */
  uint32_t addresses;      /* sum of 1u << SELVAGE_ADDRESS_CLAMP, ...; 0: all */
  uint32_t lacks;          /* sum of SELVAGE_LACKS_PERSPECTIVE, ... */
  int32_t longest_side_px; /* of the target; 0: any */
  int32_t longest_side_texel; /* of the texture; 0: any */
  int32_t most_vertices;      /* 3: triangles alone; 0: any number */
  int32_t accuracy;           /* 1/65536 texel: a texel may be that of a (u, v) so far off in u and
                                 in v; 0: exact. Of SELVAGE_PROFILE_EXACT: others have bounds */
  int32_t position_step;      /* 1/256 px: x, y are multiples of it: a power of two up to 256, which
                                 takes whole pixels alone; 0: 1 */
  int32_t coordinate_step;    /* 1/65536 texel: u, v likewise, up to 65536: whole texels; 0: 1 */
  int32_t coverage_accuracy;  /* 1/65536 px, up to 65536: a pixel may be drawn or not where its
                                 centre lies no further from the outline, in x and in y; 0: exact.
                                 Of SELVAGE_PROFILE_EXACT */
  int32_t guard_band_px;      /* x, y lie so far beyond the target at most; 0: anywhere */
} selvage_claims;

/* Must stay valid; called once, before anything is drawn. */
SELVAGE_API const selvage_claims* selvage_subject(void);

#ifdef __cplusplus
}
#endif

#endif
