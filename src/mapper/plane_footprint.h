// The footprint under one map of a whole polygon, for the area filter.
//
// Under an affine map all pixels have the same. Under a projective one, u = N / Q with
// N = n D + x A_x + y A_y and Q = q D + x B_x + y B_y, integers by the frame of the plane, and
//
//     |du/dx| + |du/dy| = D (|J_x| + |J_y|) / Q^2,     J_x = E_x + y G,   J_y = E_y - x G,
//     E_x = A_x q - n B_x,   E_y = A_y q - n B_y,   G = N_2 Q_3 - N_3 Q_2 = (A_x B_y - A_y B_x) / D
//
// for (A_x Q - N B_x) / D loses its terms in x, and the other its terms in y. N_2 to Q_3 are the
// changes from the frame's first vertex to the others.
#pragma once

#include <cstdint>

#include "mapper/footprint.h"
#include "mapper/lanes.h"
#include "mapper/number.h"
#include "mapper/plane_frame.h"
#include "mapper/polygon.h"
#include "mapper/span.h"

namespace selvage::mapper {

// Of all pixels of an affine polygon whose vertices lie on this frame's plane.
[[nodiscard]] BoxSides affine_sides(const PlaneFrame& frame);

// In units of 2^-53, the error of a side in double, relative to the reach, two more and the most
// that its numerator can be in the rectangle.
inline constexpr double kSideRoundings = 20;

// One side of the boxes of a row, in double: (across + |down|) weight^2 in 1/256 texel, where
// `weight` is the reciprocal of the lanes' denominator; off by less than slack weight^2.
struct FootprintLine {
  double across, down_start, down_step, slack;
};

// Of pixels 0, 1 .. of a span.
struct FootprintRow {
  FootprintLine u, v;
  DividedLanes::Linear denominator;

  // Whether the first `count` boxes are surely the least.
  [[nodiscard]] bool is_least(int32_t count) const;
};

class PlaneFootprint {
 public:
  // The lanes are those of the polygon's projective plane, which it has, for what is visible.
  PlaneFootprint(const Polygon& polygon, const selvage_rect& visible, const ProjectiveField& lanes);

  [[nodiscard]] FootprintRow row(const Span& span) const;
  // Whether all visible boxes are surely the least.
  [[nodiscard]] bool is_least() const { return is_least(u_) && is_least(v_); }

  // By integers, at a pixel of the polygon, where no side is below `least` or above `most`.
  [[nodiscard]] BoxSides exact(int32_t px, int32_t row, BoxSides least, BoxSides most) const;

 private:
  struct Terms {
    int128 across_start, down_start, gradient;  // E_x, E_y and G
  };
  // J_x = across_start + (row - first_row) step, J_y = down_start - (px - first_px) step, times a
  // unit.
  struct Line {
    double across_start, down_start, step, slack;
  };

  [[nodiscard]] static Terms terms(const PlaneFrame& frame, int32_t selvage_vertex::*of);
  [[nodiscard]] Line line(const Terms& terms, double unit) const;
  [[nodiscard]] FootprintLine of_span(const Line& line, const Span& span) const;
  [[nodiscard]] bool is_least(const Line& line) const;
  [[nodiscard]] Wide changes(const Terms& terms, int64_t x, int64_t y) const;

  PlaneFrame frame_;
  ProjectiveField lanes_;
  double columns_, rows_;  // that are visible
  Terms u_terms_, v_terms_;
  Line u_, v_;
};

// A change of u q is at most 2^56, of q below 2^24; A is below 2^81 and B below 2^49 (PlaneFrame),
// so E below 2^106, G below 2^82 and a J, x and y being at most 2^24, below 2^108. With D < 2^49
// and Q < 2^73 all products fit Wide.
static_assert(kTexelBits + kQBits + 1 + kPositionBits + 2 + kQBits <= 106);

}  // namespace selvage::mapper
