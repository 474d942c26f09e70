// The plane: the affine map of a whole polygon, where it has one.
//
// u = u_0 + ((x - x_0) A + (y - y_0) B) / D everywhere, and likewise v, with integers A, B and D
// from three vertices. Spans start from gradients that are divided once a polygon.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "mapper/number.h"
#include "mapper/plane_frame.h"
#include "mapper/plane_lanes.h"
#include "mapper/polygon.h"

namespace selvage::mapper {

class Plane {
 public:
  // Empty where the polygon is not affine, where some vertex lies off the plane of the others,
  // where it has no area, or where find_lanes finds none. Spans lie within `part`, a part_of()
  // the polygon that is not empty. Refers to the polygon's vertices.
  //
  // The plane is made in its place: a copy would load by sixteens of bytes what was just stored by
  // eights, and wait for it.
  [[nodiscard]] static std::optional<Plane> of(const Polygon& polygon, const selvage_rect& part,
                                               FindLanes find_lanes = find_lanes_scalar) {
    std::optional<Plane> plane(std::in_place, polygon, part);
    const bool is_plane = polygon.affine && plane->frame_.doubled_area() != 0 &&
                          (polygon.vertices.size() == 3 || plane->holds(polygon.vertices));
    if (!is_plane || !find_lanes(plane->frame_, &plane->lanes_)) plane.reset();
    return plane;
  }

  // Without lanes yet: the pixels that they are of, and what they lack at most.
  Plane(const Polygon& polygon, const selvage_rect& part)
      : frame_(PlaneFrame::of(polygon.vertices)) {
    lanes_.first_px = part.left;
    lanes_.first_row = part.top;
    const int32_t steps = part.right - part.left + part.bottom - part.top + 1;
    lanes_.margin_fx32 = kPlaneErrorPerStep_fx32 * static_cast<uint32_t>(steps);
  }

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
  [[nodiscard]] bool holds(std::span<const selvage_vertex> vertices) const;
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
