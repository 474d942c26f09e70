// What decides near-ties: the exact map behind a row's lanes, whichever it is.
#pragma once

#include <cstdint>

#include "mapper/plane.h"
#include "mapper/span.h"

namespace selvage::mapper {

// Refers to the map; one call is one comparison of 128-bit integers.
class ExactTexel {
 public:
  explicit ExactTexel(const SpanMap& map)
      : map_(&map),
        u_texel_([](const void* of, int32_t px, int32_t /*row*/, int32_t low) {
          return static_cast<const SpanMap*>(of)->u_texel(px, low);
        }),
        v_texel_([](const void* of, int32_t px, int32_t /*row*/, int32_t low) {
          return static_cast<const SpanMap*>(of)->v_texel(px, low);
        }) {}
  explicit ExactTexel(const Plane& plane)
      : map_(&plane),
        u_texel_([](const void* of, int32_t px, int32_t row, int32_t low) {
          return static_cast<const Plane*>(of)->u_texel(px, row, low);
        }),
        v_texel_([](const void* of, int32_t px, int32_t row, int32_t low) {
          return static_cast<const Plane*>(of)->v_texel(px, row, low);
        }) {}

  // floor u and floor v at a pixel, of which it is known that they are `low_texel` or one more.
  [[nodiscard]] int32_t u(int32_t px, int32_t row, int32_t low_texel) const {
    return u_texel_(map_, px, row, low_texel);
  }
  [[nodiscard]] int32_t v(int32_t px, int32_t row, int32_t low_texel) const {
    return v_texel_(map_, px, row, low_texel);
  }

 private:
  using Decide = int32_t (*)(const void* of, int32_t px, int32_t row, int32_t low_texel);
  const void* map_;
  Decide u_texel_, v_texel_;
};

}  // namespace selvage::mapper
