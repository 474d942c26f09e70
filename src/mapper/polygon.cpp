#include "mapper/polygon.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "mapper/number.h"

namespace selvage::mapper {
namespace {

[[nodiscard]] bool position_in_range(int32_t position_fx8) {
  return SELVAGE_X_MIN <= position_fx8 && position_fx8 < SELVAGE_X_END;
}
[[nodiscard]] bool q_in_range(int32_t q) { return 1 <= q && q <= SELVAGE_Q_MAX; }

// Of vertices of which some number is out of range: of the first one's first.
[[nodiscard]] selvage_status range_error(std::span<const selvage_vertex> vertices) {
  const auto is_placed = [](const selvage_vertex& v) {
    return position_in_range(v.x) && position_in_range(v.y);
  };
  const auto is_in_range = [&](const selvage_vertex& v) { return is_placed(v) && q_in_range(v.q); };
  const auto first = std::ranges::find_if_not(vertices, is_in_range);
  return is_placed(*first) ? SELVAGE_ERROR_VERTEX_Q : SELVAGE_ERROR_VERTEX_POSITION;
}

// The least and the most of each number of some vertices. x, y, u and v are side by side for
// compilers to make a vector of them.
struct VertexBox {
  enum { kX, kY, kU, kV };
  using Numbers = std::array<int32_t, 4>;

  Numbers least, most;
  int32_t least_q, most_q;

  explicit VertexBox(std::span<const selvage_vertex> vertices)
      : least(numbers_of(vertices[0])), most(least), least_q(vertices[0].q), most_q(least_q) {
    for (const selvage_vertex& v : vertices.subspan(1)) {
      widen_by(numbers_of(v));
      least_q = std::min(least_q, v.q);
      most_q = std::max(most_q, v.q);
    }
  }

  [[nodiscard]] bool in_range() const {
    return position_in_range(least[kX]) && position_in_range(most[kX]) &&
           position_in_range(least[kY]) && position_in_range(most[kY]) && q_in_range(least_q) &&
           q_in_range(most_q);
  }

 private:
  [[nodiscard]] static Numbers numbers_of(const selvage_vertex& v) { return {v.x, v.y, v.u, v.v}; }
  void widen_by(const Numbers& numbers) {
    for (size_t i = 0; i < numbers.size(); ++i) {
      least[i] = std::min(least[i], numbers[i]);
      most[i] = std::max(most[i], numbers[i]);
    }
  }
};

// The first vertex of this y, which one has. A triangle's is found without a guess.
[[nodiscard]] size_t first_at(int32_t y_fx8, std::span<const selvage_vertex> vertices) {
  if (vertices.size() == 3) {
    const size_t not_first = vertices[0].y != y_fx8, not_second = vertices[1].y != y_fx8;
    return not_first + (not_first & not_second);
  }
  size_t at = 0;
  while (vertices[at].y != y_fx8) ++at;
  return at;
}

// A closed outline crosses every scan line at most twice if and only if its edges, horizontal ones
// apart, turn from down to up once around, and from up to down once. One of the two turns may lie
// where the loop starts and ends, unseen; with more than two, three at least are seen.
[[nodiscard]] bool is_monotone(std::span<const selvage_vertex> vertices) {
  int turns = 0;
  int32_t last = 0;  // direction: +1 down, -1 up, 0 none yet
  const selvage_vertex* from = &vertices.back();
  for (const selvage_vertex& to : vertices) {
    const int32_t direction = (to.y > from->y) - (to.y < from->y);
    from = &to;
    turns += direction * last < 0 ? 1 : 0;
    last = direction != 0 ? direction : last;
  }
  return turns <= 2;
}

// u - x, in 1/65536 of either unit.
[[nodiscard]] int64_t shift_fx16(int32_t position_fx8, int32_t texel_fx16) {
  return int64_t{texel_fx16} - (int64_t{position_fx8} << (kTexelFraction - kSubpixelBits));
}

[[nodiscard]] bool is_whole(int64_t fx16) {
  return (fx16 & ((int64_t{1} << kTexelFraction) - 1)) == 0;
}

// One shift for all vertices is one shift for all that is interpolated between them.
void find_shift(Polygon* polygon) {
  const selvage_vertex& first = polygon->vertices[0];
  const int64_t ds = shift_fx16(first.x, first.u), dt = shift_fx16(first.y, first.v);
  polygon->untransformed = polygon->affine && is_whole(ds) && is_whole(dt);
  if (!polygon->untransformed) return;
  for (const selvage_vertex& v : polygon->vertices) {
    if (shift_fx16(v.x, v.u) != ds || shift_fx16(v.y, v.v) != dt) polygon->untransformed = false;
  }
  polygon->ds = static_cast<int32_t>(ds >> kTexelFraction);
  polygon->dt = static_cast<int32_t>(dt >> kTexelFraction);
}

}  // namespace

selvage_status examine(std::span<const selvage_vertex> vertices, Polygon* polygon) {
  if (vertices.size() < 3) return SELVAGE_ERROR_VERTEX_COUNT;
  const VertexBox box(vertices);
  if (!box.in_range()) return range_error(vertices);
  // A triangle turns twice at most.
  if (vertices.size() > 3 && !is_monotone(vertices)) return SELVAGE_ERROR_NOT_MONOTONE;

  // Field by field: a whole Polygon would be copied by sixteens of bytes from where it was just
  // made by eights, and wait for it.
  const auto& [least, most, least_q, most_q] = box;
  polygon->vertices = vertices;
  polygon->top = first_at(least[VertexBox::kY], vertices);
  polygon->left_px = first_centre_px(least[VertexBox::kX]);
  polygon->top_row = first_centre_px(least[VertexBox::kY]);
  polygon->right_px = first_centre_px(most[VertexBox::kX]);
  polygon->bottom_row = first_centre_px(most[VertexBox::kY]);
  polygon->texels = {least[VertexBox::kU], least[VertexBox::kV], most[VertexBox::kU],
                     most[VertexBox::kV]};
  polygon->affine = least_q == most_q;
  find_shift(polygon);
  return SELVAGE_OK;
}

}  // namespace selvage::mapper
