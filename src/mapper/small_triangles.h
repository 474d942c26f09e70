// Small triangles of one affine map each: some of them are drawn by one call, in order, set up
// together.
//
// The set-up of one is a chain of operations that wait for each other; that of several is the same
// chain, of vectors.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "mapper/number.h"
#include "mapper/polygon.h"
#include "mapper/span_batch.h"
#include "selvage.h"

namespace selvage::mapper {

// What is small to a kernel: pixels either way, visible or not, and texels of a texture of rows;
// nothing is, at first.
struct SmallLimits {
  int32_t most_px = 0, most_columns_texel = 0, most_rows_texel = 0;
};

class SmallTriangles {
 public:
  static constexpr size_t kMost = kMostDoubles;

  // Whether any of a texture are taken.
  [[nodiscard]] static bool take_from(const selvage_texture& texture, const SmallLimits& limits) {
    return limits.most_px > 0 && texture.layout == SELVAGE_LAYOUT_ROWS;
  }
  // Of such a texture. Its texels lie in it.
  [[nodiscard]] static bool take(const Polygon& polygon, const selvage_texture& texture,
                                 const SmallLimits& limits) {
    const TexelBox& box = polygon.texels;
    const int32_t s = box.least_u_fx16 >> kTexelFraction,
                  last_s = box.most_u_fx16 >> kTexelFraction;
    const int32_t t = box.least_v_fx16 >> kTexelFraction,
                  last_t = box.most_v_fx16 >> kTexelFraction;
    return polygon.right_px - polygon.left_px <= limits.most_px &&
           polygon.bottom_row - polygon.top_row <= limits.most_px && polygon.vertices.size() == 3 &&
           polygon.affine && s >= 0 && t >= 0 && last_s < texture.width &&
           last_t < texture.height && last_s - s < limits.most_columns_texel &&
           last_t - t < limits.most_rows_texel;
  }

  // One that is taken and its part_of(), which is not empty, while there are fewer than kMost.
  // Refers to the polygon.
  void add(const Polygon& polygon, const selvage_rect& part) {
    polygons_[count_] = &polygon;
    left_px_[count_] = part.left;
    right_px_[count_] = part.right;
    first_row_[count_] = part.top;
    end_row_[count_] = part.bottom;
    ++count_;
  }
  void clear() { count_ = 0; }

  [[nodiscard]] size_t count() const { return count_; }
  [[nodiscard]] const Polygon& polygon(size_t i) const { return *polygons_[i]; }
  // Their parts', with room for kMost.
  [[nodiscard]] const int32_t* left_px() const { return left_px_.data(); }
  [[nodiscard]] const int32_t* right_px() const { return right_px_.data(); }
  [[nodiscard]] const int32_t* first_row() const { return first_row_.data(); }
  [[nodiscard]] const int32_t* end_row() const { return end_row_.data(); }

 private:
  size_t count_ = 0;
  std::array<const Polygon*, kMost> polygons_;
  std::array<int32_t, kMost> left_px_{}, right_px_{}, first_row_{}, end_row_{};
};

}  // namespace selvage::mapper
