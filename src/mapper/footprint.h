// The footprint: how many texels a pixel is wide and high, for the area filter.
//
// On a row the map is u = N / D, where N = U_L w_L + U_R w_R and likewise D, with what the two
// edges carry and the distances w to the other edge (SpanMap). Edges are straight, so all of these
// have exact changes along x and along y, and
//
//     |du/dx| + |du/dy| = (|N_x D - N D_x| + |N_y D - N D_y|) / D^2.
//
// With x, y in 1/256 px and u in 1/65536 texel this is in 1/256 texel per pixel, as it is needed.
#pragma once

#include <algorithm>
#include <cstdint>

#include "mapper/edge.h"
#include "mapper/number.h"
#include "mapper/wide.h"

namespace selvage::mapper {

// The sides of a box, 1/256 texel: at least a texel, at most all texels that coordinates reach.
struct BoxSides {
  int32_t u_fx8, v_fx8;
  friend bool operator==(const BoxSides&, const BoxSides&) = default;
};
inline constexpr int32_t kLeastSide_fx8 = 1 << 8;
inline constexpr int32_t kMostSide_fx8 = 1 << 24;

// ceil of a double within these.
[[nodiscard]] inline int32_t ceil_side(double side_fx8) {
  const double inside = std::clamp<double>(side_fx8, kLeastSide_fx8, kMostSide_fx8);
  const auto whole = static_cast<int32_t>(inside);
  return whole + (whole < inside ? 1 : 0);
}

// The least side in [least, most] that is not below sum / denominator^2, or most.
[[nodiscard]] int32_t least_side(const Wide& sum, uint128 denominator, int32_t least, int32_t most);

// In units of 2^-53, the error of a footprint in double, relative to its terms without their signs.
inline constexpr double kFootprintRoundings = 44;

// One row of a polygon.
class Footprint {
 public:
  Footprint(const EdgePoint& left, const EdgeChange& left_change, const EdgePoint& right,
            const EdgeChange& right_change);

  // ceil of the footprint's sides at a pixel between the edges, within the least and the most.
  [[nodiscard]] BoxSides at(int32_t px) const;

 private:
  // What is linear along a row, by the place in 1/256 px. Modulo 2^128: at place 0, which may lie
  // far beyond the edges, it may be longer than anything between them.
  struct Line {
    uint128 start, step;

    [[nodiscard]] int128 at(int64_t place_fx8) const {
      return static_cast<int128>(start + static_cast<uint128>(place_fx8) * step);
    }
  };
  // N or D along the row, and its change along y. Its change along x is the step.
  struct Row {
    Line value, along_y;
    double along_x;
  };
  // N or D at a place with its changes, and all three rounded to double.
  struct Terms {
    int128 value, along_x, along_y;
    double near_value, near_along_x, near_along_y;
  };
  [[nodiscard]] static Terms terms(const Row& row, int64_t place_fx8);
  [[nodiscard]] static int32_t side_fx8(const Terms& n, const Terms& d);

  Row u_, v_, q_;
};

// |N| < 2^127 and D < 2^96 by SpanMap's bounds, D here without its 16 bits of fraction. N_x is a
// difference of two edge values times a height; N_y a sum of four terms as long. Products and their
// sums stay below 2^(127 + 77), and a side times D^2 below 2^(24 + 192).
static_assert(kDenominatorBits - kTexelFraction == 96);
static_assert(kEdgeBits + kPositionBits + 2 < 127 && kQBits + 2 * kPositionBits + 5 <= 77);

}  // namespace selvage::mapper
