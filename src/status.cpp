#include "selvage.h"

const char* selvage_status_text(selvage_status status) {
  switch (status) {
    case SELVAGE_OK:
      return "no error";
    case SELVAGE_ERROR_TARGET_NULL:
      return "the target or its pixels are NULL; both must point to memory";
    case SELVAGE_ERROR_TARGET_FORMAT:
      return "the target's format is unknown; it must be INDEX8, RGB565 or RGBA8888";
    case SELVAGE_ERROR_TARGET_SIZE:
      return "the target is empty; width and height must be at least 1 pixel";
    case SELVAGE_ERROR_TARGET_PITCH:
      return "the target's pitch is wrong; its magnitude must be at least a row, a multiple of a "
             "pixel, and keep the image within PTRDIFF_MAX bytes";
    case SELVAGE_ERROR_TARGET_ALIGNMENT:
      return "the target's pixels are misaligned; the address must be a multiple of a pixel";
    case SELVAGE_ERROR_TEXTURE_NULL:
      return "the texture or its texels are NULL; both must point to memory";
    case SELVAGE_ERROR_TEXTURE_FORMAT:
      return "the texture's format is unknown; it must be INDEX8, RGB565 or RGBA8888";
    case SELVAGE_ERROR_TEXTURE_SIZE:
      return "the texture is empty; width and height must be at least 1 texel";
    case SELVAGE_ERROR_TEXTURE_LAYOUT:
      return "the texture's layout is unknown; it must be ROWS or TILES";
    case SELVAGE_ERROR_TEXTURE_PITCH:
      return "the texture's pitch is wrong; its magnitude must be at least a row, a multiple of a "
             "texel, and keep the image within PTRDIFF_MAX bytes; with tiles it must be positive, "
             "at least a row of tiles and a multiple of a tile";
    case SELVAGE_ERROR_TEXTURE_ALIGNMENT:
      return "the texture's texels are misaligned; the address must be a multiple of a texel, with "
             "tiles of a tile";
    case SELVAGE_ERROR_TEXTURE_PREPARED:
      return "the texture's sums are not behind its texels; prepared must be NULL or what "
             "selvage_prepare gave";
    case SELVAGE_ERROR_FORMAT_MISMATCH:
      return "target and texture differ in format; they must have the same one";
    case SELVAGE_ERROR_OVERLAP:
      return "the texture or the vertices share memory with the target; they must lie apart";
    case SELVAGE_ERROR_VERTICES_NULL:
      return "the vertices are NULL; they must point to at least 3";
    case SELVAGE_ERROR_VERTEX_COUNT:
      return "the polygon has fewer than 3 vertices; it must have at least 3";
    case SELVAGE_ERROR_VERTEX_POSITION:
      return "a vertex lies out of range; x and y must be in [-32768, 32768) pixels";
    case SELVAGE_ERROR_VERTEX_Q:
      return "a vertex's q is out of range; it must be in 1 .. 2^24";
    case SELVAGE_ERROR_NOT_MONOTONE:
      return "the polygon is not y-monotone; every scan line must cross two edges or none";
    case SELVAGE_ERROR_VERTEX_FRACTION:
      return "a vertex lies between pixels; in a historic profile x and y must be whole pixels";
    case SELVAGE_ERROR_VERTEX_Q_DIFFERS:
      return "the vertices differ in q; in a historic profile all must be equal";
    case SELVAGE_ERROR_PROFILE:
      return "the profile is unknown; it must be EXACT, ABRASH56, ABRASH57 or DKIT";
    case SELVAGE_ERROR_FILTER:
      return "the filter is unknown; it must be NEAREST, FOUR, BILINEAR or AREA";
    case SELVAGE_ERROR_FILTER_PROFILE:
      return "a historic profile knows no filters; the filter must be NEAREST, or the profile "
             "EXACT";
    case SELVAGE_ERROR_FILTER_FORMAT:
      return "the format cannot be filtered; the filter must be NEAREST, or the format RGBA8888";
    case SELVAGE_ERROR_LAYOUT_PROFILE:
      return "a historic profile draws from rows; the layout must be ROWS, or the profile EXACT";
    case SELVAGE_ERROR_ADDRESS:
      return "the address mode is unknown; it must be CLAMP or WRAP";
    case SELVAGE_ERROR_TOLERANCE:
      return "the tolerance is negative; it must be at least 0";
    case SELVAGE_ERROR_KERNEL:
      return "the kernel is unknown, or cannot run on this machine; it must be FASTEST, SCALAR or "
             "one that selvage_has_kernel tells of";
    case SELVAGE_ERROR_THREADS:
      return "the number of threads is negative; it must be at least 1, or 0 for all there are";
    case SELVAGE_ERROR_POLYGONS_NULL:
      return "the polygons are NULL; they must point to as many as are counted";
    case SELVAGE_ERROR_SCRATCH_NULL:
      return "the scratch memory is NULL; it must point to selvage_draw_many_bytes bytes";
    case SELVAGE_ERROR_SCRATCH_ALIGNMENT:
      return "the scratch memory is misaligned; it must be aligned as max_align_t is";
    case SELVAGE_ERROR_SCRATCH_SIZE:
      return "the scratch memory is too small; it must have selvage_draw_many_bytes bytes";
    case SELVAGE_ERROR_SCRATCH_OVERLAP:
      return "the scratch memory is shared with the target, a polygon or a texture; it must lie "
             "apart";
    case SELVAGE_ERROR_SNAP_NULL:
      return "there is no vertex to write to; it must not be NULL";
    case SELVAGE_ERROR_SNAP_NOT_FINITE:
      return "a coordinate is a NaN or an infinity; all must be finite";
    case SELVAGE_ERROR_SNAP_POSITION:
      return "a position is out of range; x and y must round into [-32768, 32768) pixels";
    case SELVAGE_ERROR_SNAP_TEXTURE:
      return "a texture coordinate is out of range; u and v must round into [-32768, 32768) texels";
    case SELVAGE_ERROR_SNAP_W:
      return "w is out of range; w and w_near must be positive, and 2^24 w_near / w must round "
             "into "
             "1 .. 2^24";
    case SELVAGE_ERROR_FIT_NULL:
      return "the corners or the fitted vertices are NULL; both must point to memory";
    case SELVAGE_ERROR_FIT_COUNT:
      return "the texture fits onto 3 or 4 corners only; the count must be one of these";
    case SELVAGE_ERROR_FIT_DOUBLED:
      return "the doubled corner is none of the three; it must be 0, 1 or 2";
    case SELVAGE_ERROR_FIT_SIZE:
      return "the texture's size is out of range; width and height must be in 1 .. 32767 texels";
    case SELVAGE_ERROR_PREPARE_NULL:
      return "the memory or the prepared texture is NULL; both must point to memory";
    case SELVAGE_ERROR_PREPARE_LAYOUT:
      return "the layout that is wanted is unknown; it must be ROWS or TILES";
    case SELVAGE_ERROR_PREPARE_SUMS:
      return "the format has no sums; with_sums must be 0, or the format RGBA8888";
    case SELVAGE_ERROR_PREPARE_ALIGNMENT:
      return "the memory is misaligned; its address must be a multiple of "
             "SELVAGE_PREPARED_ALIGNMENT, 64 bytes";
    case SELVAGE_ERROR_PREPARE_SIZE:
      return "the memory is too small; it must hold what selvage_prepare_bytes says";
    case SELVAGE_ERROR_PREPARE_OVERLAP:
      return "the memory shares bytes with the source, its descriptor or the prepared one; they "
             "must "
             "lie apart";
    case SELVAGE_ERROR_CHOICE_NULL:
      return "choice is NULL; it must point to a selvage_choice to write to";
    case SELVAGE_ERROR_MEASURE_WORK:
      return "the work to measure is unknown; it must be LARGE, MESH or PERSPECTIVE";
    case SELVAGE_ERROR_MEASURE_NULL:
      return "the memory to measure in, or the kernel to write to, is NULL; both must point to "
             "memory";
    case SELVAGE_ERROR_MEASURE_ALIGNMENT:
      return "the memory to measure in is misaligned; it must be aligned as max_align_t is";
    case SELVAGE_ERROR_MEASURE_SIZE:
      return "the memory to measure in is too small; it must have SELVAGE_FASTEST_KERNEL_BYTES";
    case SELVAGE_ERROR_MEASURE_OVERLAP:
      return "the kernel to write to lies in the memory to measure in; it must lie outside";
    default:
      return "unknown status";
  }
}
