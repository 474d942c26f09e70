// Affine maps over a target, for tests that choose them.
#pragma once

#include <cmath>

#include "spec/case.h"
#include "spec/random.h"

namespace selvage::mapper {

// Texels where the target's first pixel begins, and how many more a pixel.
struct TexelMap {
  double u, v, u_per_px, v_per_px, u_per_row, v_per_row;

  [[nodiscard]] double u_at(double x_px, double y_px) const {
    return u + x_px * u_per_px + y_px * u_per_row;
  }
  [[nodiscard]] double v_at(double x_px, double y_px) const {
    return v + x_px * v_per_px + y_px * v_per_row;
  }
};

// Moves a map of some slopes: the middle of the target onto that of the texture, or anywhere; of
// ties onto quarters of a texel.
inline void move(spec::Random& random, const spec::Case& c, bool fits, bool ties, TexelMap* map) {
  const double half_px = c.target_width_px / 2.0, half_rows = c.target_height_px / 2.0;
  map->u = map->v = 0;
  const double u = c.texture_width_texel / 2.0 - map->u_at(half_px, half_rows);
  const double v = c.texture_height_texel / 2.0 - map->v_at(half_px, half_rows);
  map->u = fits ? u : random.in(-300, 300) / 4.0;
  map->v = fits ? v : random.in(-300, 300) / 4.0;
  if (!ties) return;
  map->u = std::round(map->u * 4) / 4;
  map->v = std::round(map->v * 4) / 4;
}

}  // namespace selvage::mapper
