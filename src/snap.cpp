#include <cmath>
#include <initializer_list>

#include "mapper/nearest_rounding.h"
#include "selvage.h"

namespace {

// The nearest integer, halves upward. value - floor is exact unless -1/2 < value < 0, where it
// comes out in [1/2, 1] as it should, so that the comparison always is (spec/proofs/snap.g).
[[nodiscard]] double round_half_up(double value) {
  const double below = std::floor(value);
  return value - below >= 0.5 ? below + 1 : below;
}

// Rounds value * scale (a power of two, so exact) into [least, end); false if it falls outside.
[[nodiscard]] bool round_into(double value, double scale, double least, double end,
                              int32_t* rounded) {
  const double nearest = round_half_up(value * scale);
  if (!(least <= nearest && nearest < end)) return false;
  *rounded = static_cast<int32_t>(nearest);
  return true;
}

}  // namespace

selvage_status selvage_snap(double x_px, double y_px, double u_texel, double v_texel, double w,
                            double w_near, selvage_vertex* vertex) {
  const selvage::mapper::NearestRounding rounding;
  if (vertex == nullptr) return SELVAGE_ERROR_SNAP_NULL;
  for (const double value : {x_px, y_px, u_texel, v_texel, w, w_near}) {
    if (!std::isfinite(value)) return SELVAGE_ERROR_SNAP_NOT_FINITE;
  }
  selvage_vertex snapped;
  if (!round_into(x_px, SELVAGE_SUBPIXELS, SELVAGE_X_MIN, SELVAGE_X_END, &snapped.x) ||
      !round_into(y_px, SELVAGE_SUBPIXELS, SELVAGE_X_MIN, SELVAGE_X_END, &snapped.y)) {
    return SELVAGE_ERROR_SNAP_POSITION;
  }
  if (!round_into(u_texel, SELVAGE_SUBTEXELS, -0x1p31, 0x1p31, &snapped.u) ||
      !round_into(v_texel, SELVAGE_SUBTEXELS, -0x1p31, 0x1p31, &snapped.v)) {
    return SELVAGE_ERROR_SNAP_TEXTURE;
  }
  if (!(w > 0 && w_near > 0) ||
      !round_into(w_near / w, SELVAGE_Q_MAX, 1, double{SELVAGE_Q_MAX} + 1, &snapped.q)) {
    return SELVAGE_ERROR_SNAP_W;
  }
  *vertex = snapped;
  return SELVAGE_OK;
}
