#include "mapper/slab.h"

namespace selvage::mapper {
namespace {

[[nodiscard]] bool are_equal(const selvage_vertex& a, const selvage_vertex& b) {
  return a.x == b.x && a.y == b.y && a.u == b.u && a.v == b.v && a.q == b.q;
}

// How far b is right of a where they cross a row, times both heights.
[[nodiscard]] int128 right_by(const Edge& a, const Edge& b, int32_t row) {
  const EdgePoint at_a = a.at(row), at_b = b.at(row);
  return int128{at_b.x} * at_a.height - int128{at_a.x} * at_b.height;
}

}  // namespace

SlabOutline::SlabOutline(const Slab& slab) {
  add(slab.a.top());
  add(slab.a.bottom());
  add(slab.b.bottom());
  if (!are_equal(slab.b.top(), corners_[0])) add(slab.b.top());
  // Two edges that cross the same rows are y-monotone, whatever joins their ends.
  static_cast<void>(examine({corners_.data(), count_}, &polygon_));
}

void SlabOutline::add(const selvage_vertex& vertex) {
  if (count_ == 0 || !are_equal(vertex, corners_[count_ - 1])) corners_[count_++] = vertex;
}

std::optional<RuledMap> RuledMap::of(const Slab& slab) {
  const int32_t last_row = slab.end_row - 1;
  const int128 first = right_by(slab.a, slab.b, slab.first_row);
  const int128 last = right_by(slab.a, slab.b, last_row);
  if (first > 0 && last > 0) return RuledMap(slab.a, slab.b, last_row);
  if (first < 0 && last < 0) return RuledMap(slab.b, slab.a, last_row);
  return std::nullopt;
}

}  // namespace selvage::mapper
