#include "mapper/slab.h"

#include <algorithm>

namespace selvage::mapper {
namespace {

[[nodiscard]] bool are_equal(const selvage_vertex& a, const selvage_vertex& b) {
  return a.x == b.x && a.y == b.y && a.u == b.u && a.v == b.v && a.q == b.q;
}

// How far b is right of a, times both heights.
[[nodiscard]] int128 right_by(const EdgePoint& a, const EdgePoint& b) {
  return int128{b.x} * a.height - int128{a.x} * b.height;
}

// The most that a denominator of the rows is, but for roundings: of one q, which is 1 then.
[[nodiscard]] double most_denominator(const Slab& slab) {
  const auto [left, right] =
      std::minmax({slab.a.top().x, slab.a.bottom().x, slab.b.top().x, slab.b.bottom().x});
  const auto height = [](const Edge& edge) {
    return static_cast<double>(int64_t{edge.bottom().y} - edge.top().y);
  };
  const double width = static_cast<double>(int64_t{right} - left);
  return width * height(slab.a) * height(slab.b) * (1 << kTexelFraction);
}

}  // namespace

SlabOutline::SlabOutline(const Slab& slab) {
  add(slab.a.top());
  add(slab.a.bottom());
  add(slab.b.bottom());
  if (!are_equal(slab.b.top(), corners_[0])) add(slab.b.top());
}

// Two edges that cross the same rows are y-monotone, whatever joins their ends.
Polygon SlabOutline::polygon() const {
  Polygon polygon;
  static_cast<void>(examine({corners_.data(), count_}, &polygon));
  return polygon;
}

void SlabOutline::add(const selvage_vertex& vertex) {
  if (count_ == 0 || !are_equal(vertex, corners_[count_ - 1])) corners_[count_++] = vertex;
}

std::optional<Slab> from_left_to_right(const Slab& slab) {
  const int128 first = right_by(slab.a.at(slab.first_row), slab.b.at(slab.first_row));
  const int128 last = right_by(slab.a.at(slab.end_row - 1), slab.b.at(slab.end_row - 1));
  if (first >= 0 && last >= 0) return slab;
  if (first <= 0 && last <= 0) return Slab{slab.b, slab.a, slab.first_row, slab.end_row};
  return std::nullopt;
}

double RuledMap::most_denominator() const {
  double most = 0;
  for (const Slab& slab : slabs()) most = std::max(most, mapper::most_denominator(slab));
  return most;
}

SpanMap RuledMap::at(int32_t row) const {
  const Slab& slab = slab_of(row);
  const auto [a, b] = slab.at(row);
  return right_by(a, b) > 0 ? SpanMap(a, b) : SpanMap(b, a);
}

}  // namespace selvage::mapper
