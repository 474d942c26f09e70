#include "mapper/footprint.h"

#include <algorithm>
#include <cmath>

#include "mapper/wide.h"

namespace selvage::mapper {
namespace {

// A number in [low, high].
struct Bounds {
  double low, high;
};

// ceil, within the sides that a box may have.
[[nodiscard]] int32_t ceil_side(double fx8) {
  return static_cast<int32_t>(
      std::ceil(std::clamp(fx8, double{kLeastSide_fx8}, double{kMostSide_fx8})));
}

}  // namespace

Footprint::Linear Footprint::mix(Weights weights, int128 left, int128 left_change, int128 right,
                                 int128 right_change) const {
  return {left * weights.left + right * weights.right, right * left_.height - left * right_.height,
          left_change * weights.left + left * right_change_.x + right_change * weights.right -
              right * left_change_.x};
}

BoxSides Footprint::at(int32_t px) const {
  const int64_t centre = centre_fx8(px);
  const Weights weights{right_.x - centre * right_.height, centre * left_.height - left_.x};
  const Linear d = mix(weights, left_.q, left_change_.q, right_.q, right_change_.q);
  const Linear u = mix(weights, left_.uq, left_change_.uq, right_.uq, right_change_.uq);
  const Linear v = mix(weights, left_.vq, left_change_.vq, right_.vq, right_change_.vq);
  return {side_fx8(u, d), side_fx8(v, d)};
}

// The least side that is not below (|N_x D - N D_x| + |N_y D - N D_y|) / D^2: by an estimate in
// double with a certified bound (spec/proofs/footprint.g), and where that leaves a choice, by
// comparisons of integers.
int32_t Footprint::side_fx8(const Linear& n, const Linear& d) {
  const auto estimate = [&] {
    const auto n0 = static_cast<double>(n.value), d0 = static_cast<double>(d.value);
    const double a = static_cast<double>(n.along_x) * d0, b = n0 * static_cast<double>(d.along_x);
    const double e = static_cast<double>(n.along_y) * d0, f = n0 * static_cast<double>(d.along_y);
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
