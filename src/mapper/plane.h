// The plane: the affine map of a whole polygon, where it has one.
//
// u = u_0 + ((x - x_0) A + (y - y_0) B) / D everywhere, and likewise v, with integers A, B and D
// from three vertices. Spans start from gradients that are divided once a polygon.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "mapper/number.h"
#include "mapper/plane_frame.h"
#include "mapper/plane_lanes.h"
#include "mapper/polygon.h"

namespace selvage::mapper {

class Plane {
 public:
  // Empty where the polygon is not affine, where some vertex lies off the plane of the others,
  // where it has no area, or where find_lanes finds none. `visible` is not empty: spans lie within
  // it. Refers to the polygon's vertices.
  [[nodiscard]] static std::optional<Plane> of(const Polygon& polygon, const selvage_rect& visible,
                                               FindLanes find_lanes = find_lanes_scalar);

  // Without lanes yet.
  Plane(const Polygon& polygon, const selvage_rect& visible);

  // Of all visible pixels of the polygon.
  [[nodiscard]] const AffineField& lanes() const { return lanes_; }

  // u = u_numerator / denominator in texels, at the centre of a pixel; steps to the next pixel.
  [[nodiscard]] int128 u_numerator(int32_t px, int32_t row) const {
    return numerator(&selvage_vertex::u, px, row);
  }
  [[nodiscard]] int128 v_numerator(int32_t px, int32_t row) const {
    return numerator(&selvage_vertex::v, px, row);
  }
  [[nodiscard]] int128 u_numerator_step() const { return step(&selvage_vertex::u); }
  [[nodiscard]] int128 v_numerator_step() const { return step(&selvage_vertex::v); }
  [[nodiscard]] int128 denominator() const {
    return int128{frame_.doubled_area()} << kTexelFraction;
  }

 private:
  // Whether the frame has an area and all vertices lie on its plane.
  [[nodiscard]] bool is_of(std::span<const selvage_vertex> vertices) const;
  [[nodiscard]] bool passes_through(const selvage_vertex& vertex) const;
  [[nodiscard]] int128 numerator(int32_t selvage_vertex::*of, int32_t px, int32_t row) const;
  [[nodiscard]] int128 step(int32_t selvage_vertex::*of) const {
    return int128{frame_.gradient_of(of).along_x} * kSubpixels;
  }

  PlaneFrame frame_;
  AffineField lanes_;
};

}  // namespace selvage::mapper
