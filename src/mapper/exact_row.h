// What decides near-ties: the exact map along a row, whichever map it is.
#pragma once

#include <cstdint>

#include "mapper/number.h"
#include "mapper/plane.h"
#include "mapper/span.h"

namespace selvage::mapper {

// u = (u + i u_step) / (d + i d_step) texels, and likewise v, at the i-th pixel from some pixel on.
// Numbers are kept modulo 2^128: they may leave their range on pixels that nobody asks for.
struct ExactRow {
  uint128 u, u_step, v, v_step;
  uint128 d, d_step;

  // floor u and floor v at a pixel, of which it is known that they are `low_texel` or one more:
  // decided by the sign of one integer, without a division. It lies in [-d, d), d at the pixel.
  [[nodiscard]] int32_t u_texel(int32_t i, int32_t low_texel) const {
    return low_texel + (is_reached(u, u_step, i, low_texel) ? 1 : 0);
  }
  [[nodiscard]] int32_t v_texel(int32_t i, int32_t low_texel) const {
    return low_texel + (is_reached(v, v_step, i, low_texel) ? 1 : 0);
  }

  // The same integers modulo 2^64 have the same sign.
  [[nodiscard]] bool fits_int64() const { return d_step == 0 && d >> 63 == 0; }

 private:
  [[nodiscard]] bool is_reached(uint128 n, uint128 n_step, int32_t i, int32_t low_texel) const {
    const auto times = static_cast<uint128>(int128{i});
    const auto next = static_cast<uint128>(int128{low_texel} + 1);
    return static_cast<int128>(n + times * n_step - next * (d + times * d_step)) >= 0;
  }
};

// Refers to the map.
class ExactMap {
 public:
  explicit ExactMap(const SpanMap& map) : map_(&map), row_from_(row_of_span) {}
  explicit ExactMap(const Plane& plane) : map_(&plane), row_from_(row_of_plane) {}

  // Of a pixel of the polygon, and the pixels right of it.
  [[nodiscard]] ExactRow row_from(int32_t px, int32_t row) const {
    return row_from_(map_, px, row);
  }

 private:
  [[nodiscard]] static ExactRow row_of_span(const void* of, int32_t px, int32_t /*row*/) {
    const auto& map = *static_cast<const SpanMap*>(of);
    const auto modular = [](int128 a) { return static_cast<uint128>(a); };
    return {modular(map.u_numerator(px)), modular(map.u_numerator_step()),
            modular(map.v_numerator(px)), modular(map.v_numerator_step()),
            modular(map.denominator(px)), modular(map.denominator_step())};
  }
  [[nodiscard]] static ExactRow row_of_plane(const void* of, int32_t px, int32_t row) {
    const auto& plane = *static_cast<const Plane*>(of);
    const auto modular = [](int128 a) { return static_cast<uint128>(a); };
    return {modular(plane.u_numerator(px, row)), modular(plane.u_numerator_step()),
            modular(plane.v_numerator(px, row)), modular(plane.v_numerator_step()),
            modular(plane.denominator()),        0};
  }

  const void* map_;
  ExactRow (*row_from_)(const void* of, int32_t px, int32_t row);
};

}  // namespace selvage::mapper
