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

  // u or v in texels is the numerator over the denominator, at the centre of a pixel, and the step
  // is to the next pixel.
  struct Numerator {
    int128 start, step;
  };
  [[nodiscard]] Numerator u_numerator(int32_t px, int32_t row) const {
    return numerator(&selvage_vertex::u, px, row);
  }
  [[nodiscard]] Numerator v_numerator(int32_t px, int32_t row) const {
    return numerator(&selvage_vertex::v, px, row);
  }
  [[nodiscard]] int128 denominator() const {
    return int128{frame_.doubled_area()} << kTexelFraction;
  }

 private:
  // Whether the frame has an area and all vertices lie on its plane.
  [[nodiscard]] bool is_of(std::span<const selvage_vertex> vertices) const;
  [[nodiscard]] bool passes_through(const selvage_vertex& vertex) const;
  [[nodiscard]] Numerator numerator(int32_t selvage_vertex::*of, int32_t px, int32_t row) const {
    const selvage_vertex& origin = frame_.origin();
    const auto [along_x, along_y] = frame_.gradient_of(of);
    return {int128{origin.*of} * frame_.doubled_area() +
                int128{centre_fx8(px) - origin.x} * along_x +
                int128{centre_fx8(row) - origin.y} * along_y,
            int128{along_x} * kSubpixels};
  }

  PlaneFrame frame_;
  AffineField lanes_;
};

}  // namespace selvage::mapper
