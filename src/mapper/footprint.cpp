#include "mapper/footprint.h"

#include <cmath>

#include "mapper/wide.h"

namespace selvage::mapper {
namespace {

// A number in [low, high].
struct Bounds {
  double low, high;
};

}  // namespace

// At a place the left edge's numbers have the weight right.x - place * right.height, and those of
// the right edge place * left.height - left.x.
Footprint::Footprint(const EdgePoint& left, const EdgeChange& left_change, const EdgePoint& right,
                     const EdgeChange& right_change) {
  const auto wide = [](int128 a) { return static_cast<uint128>(a); };
  const auto row = [&](int128 on_left, int128 change_left, int128 on_right, int128 change_right) {
    const auto weighed = [&](int128 a, int128 b) {
      return Line{wide(a) * wide(right.x) - wide(b) * wide(left.x),
                  wide(b) * wide(left.height) - wide(a) * wide(right.height)};
    };
    const Line value = weighed(on_left, on_right);
    Line along_y = weighed(change_left, change_right);
    along_y.start += wide(on_left) * wide(right_change.x) - wide(on_right) * wide(left_change.x);
    return Row{value, along_y, static_cast<double>(static_cast<int128>(value.step))};
  };
  u_ = row(left.uq, left_change.uq, right.uq, right_change.uq);
  v_ = row(left.vq, left_change.vq, right.vq, right_change.vq);
  q_ = row(left.q, left_change.q, right.q, right_change.q);
}

Footprint::Terms Footprint::terms(const Row& row, int64_t place_fx8) {
  const int128 value = row.value.at(place_fx8), along_y = row.along_y.at(place_fx8);
  return {value,       static_cast<int128>(row.value.step), along_y, static_cast<double>(value),
          row.along_x, static_cast<double>(along_y)};
}

BoxSides Footprint::at(int32_t px) const {
  const int64_t centre = centre_fx8(px);
  const Terms d = terms(q_, centre);
  return {side_fx8(terms(u_, centre), d), side_fx8(terms(v_, centre), d)};
}

// The least side that is not below (|N_x D - N D_x| + |N_y D - N D_y|) / D^2: by an estimate in
// double with a certified bound (spec/proofs/footprint.g), and where that leaves a choice, by
// comparisons of integers.
int32_t Footprint::side_fx8(const Terms& n, const Terms& d) {
  const auto estimate = [&] {
    const double n0 = n.near_value, d0 = d.near_value;
    const double a = n.near_along_x * d0, b = n0 * d.near_along_x;
    const double e = n.near_along_y * d0, f = n0 * d.near_along_y;
    const double sum = std::abs(a - b) + std::abs(e - f);
    const double slack =
        (std::abs(a) + std::abs(b) + std::abs(e) + std::abs(f)) * (kFootprintRoundings * 0x1p-53);
    return Bounds{(sum - slack) / (d0 * d0), (sum + slack) / (d0 * d0)};
  };
  const Bounds bounds = estimate();
  int32_t least = ceil_side(bounds.low), most = ceil_side(bounds.high);
  if (least == most) return least;
  const Wide sum = distance(n.along_x, d.value, n.value, d.along_x) +
                   distance(n.along_y, d.value, n.value, d.along_y);
  return least_side(sum, static_cast<uint128>(d.value), least, most);
}

int32_t least_side(const Wide& sum, uint128 denominator, int32_t least, int32_t most) {
  while (least < most) {
    const int32_t middle = least + (most - least) / 2;
    const bool enough = product(denominator * static_cast<uint128>(middle), denominator) >= sum;
    most = enough ? middle : most;
    least = enough ? least : middle + 1;
  }
  return least;
}

}  // namespace selvage::mapper
