// The plane: the affine map of a whole polygon, where it has one.
//
// u = u_0 + ((x - x_0) A + (y - y_0) B) / D everywhere, and likewise v, with integers A, B and D
// from three vertices. Spans start from gradients that are divided once a polygon.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "mapper/lanes.h"
#include "mapper/number.h"
#include "mapper/plane_frame.h"
#include "mapper/polygon.h"
#include "mapper/span.h"

namespace selvage::mapper {

// Estimates of gradients in double, up to 2^52 units, are off by a few units at most.
inline constexpr double kMostPlaneEstimate_fx32 = 0x1p52;
inline constexpr int kPlaneEstimateError_fx32 = 6;
// A lane is low by less than so many units for the start and for each step from it.
inline constexpr uint32_t kPlaneErrorPerStep_fx32 = 1;

// u or v over the polygon. Positions are in 1/256 px from the origin vertex.
struct PlaneCoordinate {
  int32_t origin_fx16;       // at the origin vertex
  int64_t along_x, along_y;  // A and B: |.| < 2^57, in 1/65536 texel * D per 1/256 px
};

class Plane {
 public:
  // Empty where the polygon is not affine, where some vertex lies off the plane of the others,
  // where it has no area, or where gradients are so steep that 64 bits do not hold them. `visible`
  // is not empty: spans lie within it.
  [[nodiscard]] static std::optional<Plane> of(const Polygon& polygon, const selvage_rect& visible);

  // Through the three vertices of a frame; without lanes.
  explicit Plane(const PlaneFrame& frame);

  // Of all visible pixels of the polygon.
  [[nodiscard]] const AffineField& lanes() const { return lanes_; }

  // u = u_numerator / denominator in texels, at the centre of a pixel; steps to the next pixel.
  [[nodiscard]] int128 u_numerator(int32_t px, int32_t row) const { return numerator(u_, px, row); }
  [[nodiscard]] int128 v_numerator(int32_t px, int32_t row) const { return numerator(v_, px, row); }
  [[nodiscard]] int128 u_numerator_step() const { return int128{u_.along_x} * kSubpixels; }
  [[nodiscard]] int128 v_numerator_step() const { return int128{v_.along_x} * kSubpixels; }
  [[nodiscard]] int128 denominator() const { return int128{doubled_area_} << kTexelFraction; }

 private:
  // Whether the frame has an area and all vertices lie on its plane.
  [[nodiscard]] bool is_of(std::span<const selvage_vertex> vertices) const;
  [[nodiscard]] bool passes_through(const selvage_vertex& vertex) const;
  [[nodiscard]] bool set_lanes(const Polygon& polygon, const selvage_rect& visible);
  // The start and the steps of one coordinate of the lanes.
  [[nodiscard]] bool set_lane(const PlaneCoordinate& coordinate, int64_t Lane::*axis);
  [[nodiscard]] int128 numerator(const PlaneCoordinate& c, int32_t px, int32_t row) const {
    return int128{c.origin_fx16} * doubled_area_ + int128{centre_fx8(px) - x_fx8_} * c.along_x +
           int128{centre_fx8(row) - y_fx8_} * c.along_y;
  }

  int32_t x_fx8_, y_fx8_;  // of the origin vertex
  int64_t doubled_area_;   // D, in (1/256 px)^2: 0 <= D < 2^49
  PlaneCoordinate u_, v_;
  AffineField lanes_{};
};

}  // namespace selvage::mapper
