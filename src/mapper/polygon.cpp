#include "mapper/polygon.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

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

// x, y, u and v of a vertex side by side, in a vector of any machine.
using Numbers [[gnu::vector_size(16)]] = int32_t;
using Bits [[gnu::vector_size(16)]] = uint32_t;
static_assert(offsetof(selvage_vertex, v) + sizeof(int32_t) == sizeof(Numbers));

[[nodiscard]] Numbers numbers_of(const selvage_vertex& vertex) {
  Numbers numbers;
  std::memcpy(&numbers, &vertex, sizeof numbers);
  return numbers;
}

// The least and the most of each number of some vertices, and the first vertex of least y.
struct VertexBox {
  Numbers least, most;
  int32_t least_q, most_q;
  size_t top = 0;

  explicit VertexBox(std::span<const selvage_vertex> vertices)
      : least(numbers_of(vertices[0])), most(least), least_q(vertices[0].q), most_q(least_q) {
    int32_t top_y_fx8 = vertices[0].y;
    for (size_t i = 1; i < vertices.size(); ++i) {
      const selvage_vertex& v = vertices[i];
      const bool is_higher = v.y < top_y_fx8;
      top = is_higher ? i : top;
      top_y_fx8 = is_higher ? v.y : top_y_fx8;
      const Numbers numbers = numbers_of(v);
      const Numbers is_less = numbers < least;
      const Numbers is_more = numbers > most;
      least = (numbers & is_less) | (least & ~is_less);
      most = (numbers & is_more) | (most & ~is_more);
      least_q = std::min(least_q, v.q);
      most_q = std::max(most_q, v.q);
    }
  }

  // The least x and y, then the most.
  [[nodiscard]] Numbers places() const { return __builtin_shufflevector(least, most, 0, 1, 4, 5); }
  // The least u and v, then the most.
  [[nodiscard]] Numbers texels() const { return __builtin_shufflevector(least, most, 2, 3, 6, 7); }

  // Counted from the least one in range, a number in range has no bits from the end's on.
  [[nodiscard]] bool in_range() const {
    constexpr uint32_t kLeast = static_cast<uint32_t>(SELVAGE_X_MIN);
    constexpr uint32_t kEnd = static_cast<uint32_t>(SELVAGE_X_END) - kLeast, kOut = ~(kEnd - 1);
    constexpr uint32_t kQEnd = SELVAGE_Q_MAX, kLeastQ = 1;
    static_assert(std::has_single_bit(kEnd) && std::has_single_bit(kQEnd));
    constexpr Bits kFirst = {kLeast, kLeast, 0, 0};
    const Bits bits = (std::bit_cast<Bits>(least) - kFirst) | (std::bit_cast<Bits>(most) - kFirst);
    const auto [xy, uv] = std::bit_cast<std::array<uint64_t, 2>>(bits);
    const uint32_t q =
        (static_cast<uint32_t>(least_q) - kLeastQ) | (static_cast<uint32_t>(most_q) - kLeastQ);
    return (xy & (uint64_t{kOut} << 32 | kOut)) == 0 && q < kQEnd;
  }
};

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
  const Numbers places = box.places();
  polygon->vertices = vertices;
  polygon->top = box.top;
  const Numbers pixels = (places + (kHalfPixel - 1)) >> kSubpixelBits;
  polygon->left_px = pixels[0];
  polygon->top_row = pixels[1];
  polygon->right_px = pixels[2];
  polygon->bottom_row = pixels[3];
  const Numbers texels = box.texels();
  polygon->texels = {texels[0], texels[1], texels[2], texels[3]};
  polygon->least_q = box.least_q;
  polygon->affine = box.least_q == box.most_q;
  find_shift(polygon);
  return SELVAGE_OK;
}

}  // namespace selvage::mapper
