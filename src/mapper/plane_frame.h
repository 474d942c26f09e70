// The frame of a plane: three vertices of a polygon that are not on one line.
//
// What is affine over the target has a value a at the first of them, and at (x, y) from there
//
//     a + (x A + y B) / D
//
// where D is the doubled area and A and B come from the changes to the other two, all of them
// integers.
#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include "mapper/number.h"
#include "selvage.h"

namespace selvage::mapper {

inline constexpr int kPlaneAreaBits = 2 * kPositionBits + 1;  // of a doubled area
inline constexpr int kTexelGradientBits = kTexelBits + 1 + kPositionBits + 1;
static_assert(kTexelGradientBits < 63);

class PlaneFrame {
 public:
  template <class Integer>
  struct Gradient {
    Integer along_x, along_y;  // A and B
  };

  // Of no area where all vertices are on one line. The three run so that it is not negative.
  [[nodiscard]] static PlaneFrame of(std::span<const selvage_vertex> vertices) {
    return vertices.size() == 3 ? PlaneFrame(vertices[0], vertices[1], vertices[2]).turned()
                                : of_outline(vertices);
  }

  // The same however the vertices are ordered, but for those in one place: the first and the last
  // of them by y and x, and the one furthest from the line through both.
  [[nodiscard]] static PlaneFrame canonical(std::span<const selvage_vertex> vertices);

  [[nodiscard]] const selvage_vertex& origin() const { return *origin_; }
  [[nodiscard]] const selvage_vertex& second() const { return *second_; }
  [[nodiscard]] const selvage_vertex& third() const { return *third_; }

  // D, in (1/256 px)^2: 0 <= D < 2^kPlaneAreaBits; 0 of no plane.
  [[nodiscard]] int64_t doubled_area() const { return doubled_area_; }

  // Of what changes by so much from the origin to the second vertex and to the third.
  template <class Integer>
  [[nodiscard]] Gradient<Integer> gradient(int64_t to_second, int64_t to_third) const {
    const int64_t x2 = int64_t{second_->x} - origin_->x, y2 = int64_t{second_->y} - origin_->y;
    const int64_t x3 = int64_t{third_->x} - origin_->x, y3 = int64_t{third_->y} - origin_->y;
    return {Integer{to_second} * y3 - Integer{to_third} * y2,
            Integer{to_third} * x2 - Integer{to_second} * x3};
  }
  // Of u or v, in 1/65536 texel * D per 1/256 px: |A|, |B| < 2^kTexelGradientBits.
  [[nodiscard]] Gradient<int64_t> gradient_of(int32_t selvage_vertex::*coordinate) const {
    const int64_t at_origin = (*origin_).*coordinate;
    return gradient<int64_t>((*second_).*coordinate - at_origin, (*third_).*coordinate - at_origin);
  }

 private:
  [[nodiscard]] static int64_t doubled_area(const selvage_vertex& a, const selvage_vertex& b,
                                            const selvage_vertex& c) {
    return (int64_t{b.x} - a.x) * (int64_t{c.y} - a.y) -
           (int64_t{c.x} - a.x) * (int64_t{b.y} - a.y);
  }
  PlaneFrame(const selvage_vertex& origin, const selvage_vertex& second,
             const selvage_vertex& third)
      : origin_(&origin),
        second_(&second),
        third_(&third),
        doubled_area_(doubled_area(origin, second, third)) {}

  [[nodiscard]] static PlaneFrame of_outline(std::span<const selvage_vertex> vertices);
  // So that the area is not negative.
  [[nodiscard]] PlaneFrame turned() const {
    PlaneFrame frame = *this;
    if (doubled_area_ < 0) {
      std::swap(frame.second_, frame.third_);
      frame.doubled_area_ = -doubled_area_;
    }
    return frame;
  }

  const selvage_vertex *origin_, *second_, *third_;
  int64_t doubled_area_;
};

}  // namespace selvage::mapper
