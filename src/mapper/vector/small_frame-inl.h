// What is affine over small polygons, several at once: a lane is a polygon. Included once for
// each SIMD target.
#if defined(SELVAGE_VECTOR_SMALL_FRAME_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_SMALL_FRAME_INL_H
#undef SELVAGE_VECTOR_SMALL_FRAME_INL_H
#else
#define SELVAGE_VECTOR_SMALL_FRAME_INL_H
#endif

#include <cstdint>

#include "mapper/vector/small_edges-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

#if SELVAGE_DRAWS_SMALL

// Gradients times the doubled area, from the changes from one vertex to the other two.
class SmallFrame {
 public:
  struct Gradient {
    RowNumbers along_x, along_y;  // 1/256 px
  };

  HWY_INLINE SmallFrame(const SmallVertices& of, const int32_t* first_px, const int32_t* first_row)
      : x2_(change(of.a.x, of.b.x)),
        y2_(change(of.a.y, of.b.y)),
        x3_(change(of.a.x, of.c.x)),
        y3_(change(of.a.y, of.c.y)),
        dx_(to_centre(first_px, of.a.x)),
        dy_(to_centre(first_row, of.a.y)) {
    const RowNumbers area = hn::MulSub(x2_, y3_, hn::Mul(x3_, y2_));
    turn_ = hn::And(area, hn::SignBit(RowTag()));
    area_ = hn::Abs(area);
  }

  [[nodiscard]] HWY_INLINE RowNumbers doubled_area() const { return area_; }
  // Of what is such at the three vertices.
  [[nodiscard]] HWY_INLINE Gradient gradient(RowNumbers a, RowNumbers b, RowNumbers c) const {
    const RowNumbers to_second = hn::Sub(b, a), to_third = hn::Sub(c, a);
    return {cross(to_second, y3_, to_third, y2_), cross(to_third, x2_, to_second, x3_)};
  }
  // At the centre of the part's first pixel, of what is such at the first vertex.
  [[nodiscard]] HWY_INLINE RowNumbers at_first_pixel(RowNumbers a, const Gradient& gradient) const {
    const RowNumbers rise = hn::MulAdd(dx_, gradient.along_x, hn::Mul(dy_, gradient.along_y));
    return hn::MulAdd(a, area_, rise);
  }

 private:
  static HWY_INLINE RowNumbers change(Columns from, Columns to) {
    return hn::Sub(number(to), number(from));
  }
  static HWY_INLINE RowNumbers to_centre(const int32_t* px, Columns from_fx8) {
    const ColumnTag d;
    const Columns corner_fx8 = hn::ShiftLeft<kSubpixelBits>(hn::LoadU(d, px));
    return number(hn::Sub(hn::Add(corner_fx8, hn::Set(d, kHalfPixel)), from_fx8));
  }
  // With the sign that it has where vertices run so that the area is not negative.
  [[nodiscard]] HWY_INLINE RowNumbers cross(RowNumbers a, RowNumbers b, RowNumbers c,
                                            RowNumbers e) const {
    return hn::Xor(hn::MulSub(a, b, hn::Mul(c, e)), turn_);
  }

  RowNumbers x2_, y2_, x3_, y3_, dx_, dy_, turn_, area_;
};

// u or v at a vertex, counted from texels.
[[nodiscard]] HWY_INLINE RowNumbers from_texel(Columns at_fx16, Columns texel) {
  return number(hn::Sub(at_fx16, hn::ShiftLeft<kTexelFraction>(texel)));
}

// How far pixels lie right of a part's first one, and below it.
struct PixelSteps {
  V32 right_px, down_px;
};

// A bit for each polygon.
[[nodiscard]] HWY_INLINE uint32_t bits_of(hn::Mask<RowTag> mask) {
  uint8_t bits[8] = {};  // as many as are stored
  hn::StoreMaskBits(RowTag(), mask, bits);
  return bits[0];
}

#endif

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
