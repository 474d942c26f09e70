// Six doubles -> selvage_snap: the nearest vertex of the grid, or the error that says why not.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "fuzz/bytes.h"
#include "selvage.h"

namespace {

constexpr double kSubpixels = SELVAGE_SUBPIXELS, kSubtexels = SELVAGE_SUBTEXELS;
constexpr double kXMin = SELVAGE_X_MIN, kXEnd = SELVAGE_X_END, kQMax = SELVAGE_Q_MAX;
constexpr double kRounding =
    0x1p-20;  // more than the quotient w_near / w can be off by, times 2^24

struct Input {
  double x_px, y_px, u_texel, v_texel, w, w_near;
};

void fail(const char* what, const Input& in, selvage_status status) {
  std::fprintf(
      stderr, "selvage_snap: %s\n  x %a y %a px, u %a v %a texels, w %a, w_near %a\n  gave: %s\n",
      what, in.x_px, in.y_px, in.u_texel, in.v_texel, in.w, in.w_near, selvage_status_text(status));
  std::abort();
}

// grid - 1/2 <= value < grid + 1/2: nearest, halves upward. Exact, for a grid value has 32 bits.
bool nearest(double value, int32_t grid) { return grid - 0.5 <= value && value < grid + 0.5; }

bool fits(double value, double low, double end) { return low - 0.5 <= value && value < end - 0.5; }

bool finite(const Input& in) {
  return std::isfinite(in.x_px) && std::isfinite(in.y_px) && std::isfinite(in.u_texel) &&
         std::isfinite(in.v_texel) && std::isfinite(in.w) && std::isfinite(in.w_near);
}

bool position_fits(const Input& in) {
  return fits(in.x_px * kSubpixels, kXMin, kXEnd) && fits(in.y_px * kSubpixels, kXMin, kXEnd);
}

bool texture_fits(const Input& in) {
  return fits(in.u_texel * kSubtexels, -0x1p31, 0x1p31) &&
         fits(in.v_texel * kSubtexels, -0x1p31, 0x1p31);
}

void check_vertex(const Input& in, const selvage_vertex& vertex) {
  if (!finite(in)) fail("accepted what is not finite", in, SELVAGE_OK);
  if (!nearest(in.x_px * kSubpixels, vertex.x) || !nearest(in.y_px * kSubpixels, vertex.y) ||
      !nearest(in.u_texel * kSubtexels, vertex.u) || !nearest(in.v_texel * kSubtexels, vertex.v)) {
    fail("x, y, u or v is not the nearest of the grid", in, SELVAGE_OK);
  }
  if (vertex.x < SELVAGE_X_MIN || vertex.x >= SELVAGE_X_END || vertex.y < SELVAGE_X_MIN ||
      vertex.y >= SELVAGE_X_END) {
    fail("x or y lies beyond the accepted range", in, SELVAGE_OK);
  }
  if (vertex.q < 1 || vertex.q > SELVAGE_Q_MAX) fail("q lies beyond its range", in, SELVAGE_OK);
  // q w = 2^24 w_near within half of w, and a rounding of the quotient.
  const double q = kQMax * (in.w_near / in.w);
  if (!(std::fabs(q - vertex.q) <= 0.5 + kRounding)) fail("q is not the nearest", in, SELVAGE_OK);
}

void check_refusal(const Input& in, selvage_status status) {
  switch (status) {
    case SELVAGE_ERROR_SNAP_NOT_FINITE:
      if (finite(in)) fail("refused as not finite what is", in, status);
      break;
    case SELVAGE_ERROR_SNAP_POSITION:
      if (finite(in) && position_fits(in)) fail("refused a position that fits", in, status);
      break;
    case SELVAGE_ERROR_SNAP_TEXTURE:
      if (finite(in) && texture_fits(in)) fail("refused texels that fit", in, status);
      break;
    case SELVAGE_ERROR_SNAP_W: {
      const double q = kQMax * (in.w_near / in.w);
      if (in.w > 0 && q > 0.5 + kRounding && q < kQMax) fail("refused a w", in, status);
      break;
    }
    default:
      fail("an error that selvage_snap does not have", in, status);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  selvage::fuzz::Bytes bytes(data, size);
  const auto in = bytes.take<Input>();
  const selvage_vertex before = {1, 2, 3, 4, 5};
  selvage_vertex vertex = before;
  const selvage_status status =
      selvage_snap(in.x_px, in.y_px, in.u_texel, in.v_texel, in.w, in.w_near, &vertex);
  if (status == SELVAGE_OK) {
    check_vertex(in, vertex);
  } else {
    check_refusal(in, status);
    if (std::memcmp(&vertex, &before, sizeof vertex) != 0) fail("wrote on an error", in, status);
  }
  if (selvage_snap(in.x_px, in.y_px, in.u_texel, in.v_texel, in.w, in.w_near, nullptr) !=
      SELVAGE_ERROR_SNAP_NULL) {
    fail("accepted a NULL vertex", in, status);
  }
  return 0;
}
