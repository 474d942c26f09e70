// Small polygons, triangles and parallelograms: some of them are drawn by one call, in order, set
// up together.
//
// The set-up of one is a chain of operations that wait for each other; that of several is the same
// chain, of vectors.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "mapper/number.h"
#include "mapper/polygon.h"
#include "mapper/span_batch.h"
#include "selvage.h"

namespace selvage::mapper {

// What is small to a kernel: pixels either way, visible or not, texels of a texture of rows, and
// how many times the least q of the vertices the greatest may be; nothing is, at first.
struct SmallLimits {
  int32_t most_px = 0, most_columns_texel = 0, most_rows_texel = 0, most_q_ratio = 1;
};

// What a texture's small polygons show: nothing beside it. Where it is clamped u and v may be its
// ends, of which its last texels are shown.
struct SmallEnds {
  int64_t most_u_fx16, most_v_fx16;

  SmallEnds(const selvage_texture& texture, selvage_address address)
      : most_u_fx16(most(texture.width, address)), most_v_fx16(most(texture.height, address)) {}

 private:
  [[nodiscard]] static int64_t most(int32_t size_texel, selvage_address address) {
    return (int64_t{size_texel} << kTexelFraction) - (address == SELVAGE_ADDRESS_CLAMP ? 0 : 1);
  }
};

class SmallPolygons {
 public:
  static constexpr size_t kMost = kMostDoubles;

  // Whether any of a texture are taken.
  [[nodiscard]] static bool take_from(const selvage_texture& texture, const SmallLimits& limits) {
    return limits.most_px > 0 && texture.layout == SELVAGE_LAYOUT_ROWS;
  }
  // Of such a texture, of which these are the ends.
  [[nodiscard]] static bool take(const Polygon& polygon, const SmallEnds& ends,
                                 const SmallLimits& limits) {
    const TexelBox& box = polygon.texels;
    const auto across = [](int32_t least_fx16, int32_t most_fx16) {
      return (most_fx16 >> kTexelFraction) - (least_fx16 >> kTexelFraction);
    };
    return polygon.right_px - polygon.left_px <= limits.most_px &&
           polygon.bottom_row - polygon.top_row <= limits.most_px &&
           std::min(box.least_u_fx16, box.least_v_fx16) >= 0 &&
           box.most_u_fx16 <= ends.most_u_fx16 && box.most_v_fx16 <= ends.most_v_fx16 &&
           across(box.least_u_fx16, box.most_u_fx16) < limits.most_columns_texel &&
           across(box.least_v_fx16, box.most_v_fx16) < limits.most_rows_texel &&
           (is_triangle(polygon, limits) || is_parallelogram(polygon));
  }

  // Whether there is room for one that is taken: those of two kinds do not go together.
  [[nodiscard]] bool has_room_for(const Polygon& polygon) const {
    return count_ < kMost && (kinds_ | kind_of(polygon)) != (kFour | kDeep);
  }
  // One that is taken and its part_of(), which is not empty, where there is room. Refers to the
  // polygon.
  void add(const Polygon& polygon, const selvage_rect& part) {
    polygons_[count_] = &polygon;
    kinds_ |= kind_of(polygon);
    vertex_count_[count_] = static_cast<int32_t>(polygon.vertices.size());
    left_px_[count_] = part.left;
    right_px_[count_] = part.right;
    first_row_[count_] = part.top;
    end_row_[count_] = part.bottom;
    ++count_;
  }
  void clear() {
    count_ = 0;
    kinds_ = 0;
  }

  [[nodiscard]] size_t count() const { return count_; }
  // All of them.
  [[nodiscard]] bool affine() const { return (kinds_ & kDeep) == 0; }
  // Any of them; all are affine then.
  [[nodiscard]] bool have_four() const { return (kinds_ & kFour) != 0; }
  [[nodiscard]] const Polygon& polygon(size_t i) const { return *polygons_[i]; }
  // With room for kMost.
  [[nodiscard]] const int32_t* vertex_count() const { return vertex_count_.data(); }
  // Their parts', with room for kMost.
  [[nodiscard]] const int32_t* left_px() const { return left_px_.data(); }
  [[nodiscard]] const int32_t* right_px() const { return right_px_.data(); }
  [[nodiscard]] const int32_t* first_row() const { return first_row_.data(); }
  [[nodiscard]] const int32_t* end_row() const { return end_row_.data(); }

 private:
  // Of polygons: with four vertices; in perspective.
  static constexpr uint32_t kFour = 1, kDeep = 2;

  [[nodiscard]] static uint32_t kind_of(const Polygon& polygon) {
    return (polygon.vertices.size() == 4 ? kFour : 0) | (polygon.affine ? 0 : kDeep);
  }
  [[nodiscard]] static bool is_triangle(const Polygon& polygon, const SmallLimits& limits) {
    return polygon.vertices.size() == 3 && (polygon.affine || is_gentle(polygon, limits));
  }
  // In the target and in the texture, so that it lies in one plane. Not of what shows the texture
  // as it is, which is copied sooner.
  [[nodiscard]] static bool is_parallelogram(const Polygon& polygon);
  [[nodiscard]] static bool is_gentle(const Polygon& polygon, const SmallLimits& limits) {
    int32_t most_q = 0;
    for (const selvage_vertex& vertex : polygon.vertices) most_q = std::max(most_q, vertex.q);
    return most_q <= int64_t{limits.most_q_ratio} * polygon.least_q;
  }

  size_t count_ = 0;
  uint32_t kinds_ = 0;
  std::array<const Polygon*, kMost> polygons_;
  std::array<int32_t, kMost> vertex_count_{}, left_px_{}, right_px_{}, first_row_{}, end_row_{};
};

}  // namespace selvage::mapper
