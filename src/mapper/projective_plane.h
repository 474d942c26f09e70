// The projective plane: the map of a whole polygon in perspective, where it has one.
//
// u q, v q and q are affine over the target, so that with integers from three vertices
//
//     u = ((u q)_0 D + x A_u + y B_u) / (q_0 D + x A_q + y B_q)        likewise v.
//
// Spans start from values that are added up in double, with one certified bound for the polygon.
//
//   name        unit                      bits   bound
//   u q, v q    1/65536 texel * q           55   |u q| <= 2^55; a change is at most 2^56
//   A, B        u q * 1/256 px              81   of q: 49
//   numerator   u q * (1/256 px)^2         107   at a pixel of the polygon's rectangle
//   denominator q * D, 16 bits longer      107   the same; times a texel column, at the polygon's
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "mapper/lanes.h"
#include "mapper/number.h"
#include "mapper/plane_frame.h"
#include "mapper/polygon.h"

namespace selvage::mapper {

inline constexpr int kPlaneGradientBits = kTexelBits + kQBits + 1 + kPositionBits + 1;
inline constexpr int kPlaneNumeratorBits = kPlaneGradientBits + kPositionBits + 2;
static_assert(kPlaneGradientBits == 81 && kPlaneNumeratorBits == 107);
static_assert(kQBits + 1 + kPositionBits <= 53, "the gradient of q is exact in double");
static_assert(kQBits + kPlaneAreaBits + kTexelFraction + kTexelBits - kTexelFraction <= 127,
              "a denominator times a texel column fits int128");

// In units of 2^-53: what converting an integer to double is off by, relative to it; and what a
// value added up is off by, relative to the most that it can be in the rectangle.
inline constexpr double kPlaneConversionRoundings = 3;
inline constexpr double kPlaneRoundings = 8.5;
// A lane's error is at most kPlaneErrorPerReach_fx32 times the plane's reach; truncating it costs a
// unit and truncating the reach another.
inline constexpr double kPlaneErrorPerReach_fx32 = 0.3;
static_assert(kPlaneErrorPerReach_fx32 < 1, "the reach itself serves as a bound");
// So few coordinates are near-ties that do not lie next to a boundary: margins are 2^-7 of a step
// of the filters' grid at most. What reaches further, slivers whose gradients are steep over their
// rectangle and the steepest depths, is left to the edges and their gentle pieces.
inline constexpr int32_t kMostReach = 1 << 16;
static_assert(2 * (int64_t{kMostReach} + kProjectiveTruncations_fx32) <= kWidestMargin_fx32);

class ProjectivePlane {
 public:
  // Empty where some vertex lies off the plane of the others, where the polygon has no area, or
  // where its reach is too large. `visible` is not empty: spans lie within it.
  [[nodiscard]] static std::optional<ProjectivePlane> of(const Polygon& polygon,
                                                         const selvage_rect& visible);

  // The same plane with lanes for all pixels of the polygon, visible or not, and the same lanes
  // however its vertices are ordered.
  [[nodiscard]] static std::optional<ProjectivePlane> of_all(const Polygon& polygon);

  // Through the three vertices of a frame; without lanes.
  explicit ProjectivePlane(const PlaneFrame& frame);

  // Of all visible pixels of the polygon.
  [[nodiscard]] const ProjectiveField& lanes() const { return lanes_; }

  // u = u_numerator / denominator in texels, at the centre of a pixel; steps to the next pixel.
  [[nodiscard]] int128 u_numerator(int32_t px, int32_t row) const { return at(uq_, px, row); }
  [[nodiscard]] int128 v_numerator(int32_t px, int32_t row) const { return at(vq_, px, row); }
  [[nodiscard]] int128 denominator(int32_t px, int32_t row) const {
    return at(q_, px, row) * (1 << kTexelFraction);
  }
  [[nodiscard]] int128 u_numerator_step() const { return uq_.along_x * kSubpixels; }
  [[nodiscard]] int128 v_numerator_step() const { return vq_.along_x * kSubpixels; }
  [[nodiscard]] int128 denominator_step() const {
    return int128{q_.along_x} * (kSubpixels << kTexelFraction);
  }

 private:
  // One of u q, v q and q: at the origin vertex, and its gradient times D.
  template <class Integer>
  struct Quantity {
    int64_t at_origin;
    Integer along_x, along_y;
  };
  template <class Integer, class Of>
  [[nodiscard]] static Quantity<Integer> quantity(const PlaneFrame& frame, const Of& of);

  [[nodiscard]] static std::optional<ProjectivePlane> by(const PlaneFrame& frame,
                                                         const Polygon& polygon,
                                                         const selvage_rect& visible);
  // Whether the frame has an area and all vertices lie on its plane.
  [[nodiscard]] bool is_of(std::span<const selvage_vertex> vertices) const;
  [[nodiscard]] bool passes_through(const selvage_vertex& vertex) const;
  [[nodiscard]] bool set_lanes(const Polygon& polygon, const selvage_rect& visible);
  template <class Integer>
  [[nodiscard]] ProjectiveField::Form line(const Quantity<Integer>& quantity, double unit) const;
  template <class Integer>
  [[nodiscard]] int128 at(const Quantity<Integer>& quantity, int32_t px, int32_t row) const {
    return int128{quantity.at_origin} * doubled_area_ +
           int128{quantity.along_x} * (centre_fx8(px) - x_fx8_) +
           int128{quantity.along_y} * (centre_fx8(row) - y_fx8_);
  }

  int32_t x_fx8_, y_fx8_;  // of the origin vertex
  int64_t doubled_area_;   // D
  Quantity<int128> uq_, vq_;
  Quantity<int64_t> q_;
  ProjectiveField lanes_;
};

}  // namespace selvage::mapper
