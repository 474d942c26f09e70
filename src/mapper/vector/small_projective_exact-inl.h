// The texels of small triangles in perspective by integers. Included once for each SIMD target.
//
// A quotient in double tells u = N / D but next to a whole texel. There N - texel * D is so short
// an integer that its low 64 bits tell its sign.
#if defined(SELVAGE_VECTOR_SMALL_PROJECTIVE_EXACT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_SMALL_PROJECTIVE_EXACT_INL_H
#undef SELVAGE_VECTOR_SMALL_PROJECTIVE_EXACT_INL_H
#else
#define SELVAGE_VECTOR_SMALL_PROJECTIVE_EXACT_INL_H
#endif

#include <cstddef>

#include "mapper/plane_frame.h"
#include "mapper/vector/small_projective-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

#if SELVAGE_DRAWS_SMALL

using WideTag = hn::RebindToSigned<RowTag>;
using Wides = hn::Vec<WideTag>;

// What a form is times the doubled area, at the part's first pixel and from there on, modulo 2^64.
struct SmallIntegers {
  uint64_t start, right, down;

  [[nodiscard]] HWY_INLINE Wides at(Wides right_px, Wides down_px) const {
    const Wides across = hn::Add(in_all(start), hn::Mul(right_px, in_all(right)));
    return hn::Add(across, hn::Mul(down_px, in_all(down)));
  }

 private:
  static HWY_INLINE Wides in_all(uint64_t value) {
    return hn::Set(WideTag(), static_cast<int64_t>(value));
  }
};

// The integers of one triangle from the changes from one of its vertices to the other two.
class SmallIntegerFrame {
 public:
  HWY_INLINE SmallIntegerFrame(const Polygon& polygon, int32_t first_px, int32_t first_row)
      : frame_(PlaneFrame::of(polygon.vertices)),
        dx_(static_cast<uint64_t>(int64_t{centre_fx8(first_px)} - frame_.origin().x)),
        dy_(static_cast<uint64_t>(int64_t{centre_fx8(first_row)} - frame_.origin().y)) {}

  // Of what is of(vertex).
  template <class Of>
  [[nodiscard]] HWY_INLINE SmallIntegers integers(const Of& of) const {
    const int64_t at_origin = of(frame_.origin());
    const auto [along_x, along_y] =
        frame_.gradient<int64_t>(of(frame_.second()) - at_origin, of(frame_.third()) - at_origin);
    const auto x = static_cast<uint64_t>(along_x), y = static_cast<uint64_t>(along_y);
    return {static_cast<uint64_t>(at_origin) * static_cast<uint64_t>(frame_.doubled_area()) +
                dx_ * x + dy_ * y,
            x * uint64_t{kSubpixels}, y * uint64_t{kSubpixels}};
  }

 private:
  PlaneFrame frame_;
  uint64_t dx_, dy_;
};

// u q or v q, u or v counted from some texel.
struct TimesDepth {
  int32_t selvage_vertex::*coordinate;
  int32_t from_texel;

  HWY_INLINE int64_t operator()(const selvage_vertex& vertex) const {
    return (vertex.*coordinate - (int64_t{from_texel} << kTexelFraction)) * vertex.q;
  }
};

// u or v, counted from a triangle's origin.
class ExactSmallForm {
 public:
  HWY_INLINE ExactSmallForm(const SmallForm& of, size_t i, const SmallIntegers& integers,
                            int32_t end_texel)
      : start_(of.start[i]),
        right_(of.right[i]),
        down_(of.down[i]),
        integers_(integers),
        last_texel_(end_texel - 1) {}

  struct Pixels {
    RowNumbers right_px, down_px;
    Wides wide_right_px, wide_down_px;
    RowNumbers reciprocal;  // of D
    Wides divisor;          // D
  };
  // Of kRows pixels, as 16.16; where the texture ends, the last one in it.
  [[nodiscard]] HWY_INLINE Columns texels_fx16(const Pixels& at) const {
    const RowTag d;
    const ColumnTag columns;
    const RowNumbers across = hn::MulAdd(at.right_px, hn::Set(d, right_), hn::Set(d, start_));
    const RowNumbers n = hn::MulAdd(at.down_px, hn::Set(d, down_), across);
    const RowNumbers estimate = hn::Mul(n, at.reciprocal);
    const RowNumbers whole = hn::Round(estimate);
    const auto texel = hn::DemoteTo(columns, whole);
    const Wides rest = hn::Sub(integers_.at(at.wide_right_px, at.wide_down_px),
                               hn::Mul(hn::PromoteTo(WideTag(), texel), at.divisor));
    const auto is_near =
        hn::Lt(hn::Abs(hn::Sub(estimate, whole)), hn::Set(d, 1.0 / (1 << kNearSmallBits)));
    const auto is_rest_below = hn::RebindMask(d, hn::Lt(rest, hn::Zero(WideTag())));
    const auto is_below =
        hn::Or(hn::And(is_near, is_rest_below), hn::AndNot(is_near, hn::Lt(estimate, whole)));
    const RowNumbers floor = hn::Sub(whole, hn::IfThenElseZero(is_below, hn::Set(d, 1.0)));
    const Columns most = hn::Set(columns, last_texel_);
    return hn::ShiftLeft<kTexelFraction>(hn::Min(hn::DemoteTo(columns, floor), most));
  }

 private:
  double start_, right_, down_;
  SmallIntegers integers_;
  int32_t last_texel_;
};

// Of the i-th one of some that were set up.
class ExactProjectiveSmall {
 public:
  HWY_INLINE ExactProjectiveSmall(const ProjectiveSmalls& of, size_t i, const SmallTexels& texels)
      : ExactProjectiveSmall(of, i, texels,
                             SmallIntegerFrame(of.polygon(i), of.first_px(i), of.first_row(i))) {}

  // Whole texels, as 16.16, of so many pixels, or more.
  [[nodiscard]] HWY_INLINE LaneVectors at(const PixelSteps& steps, int32_t count_px) const {
    const D32 d;
    const ColumnTag half;
    const Half lower =
        half_at(hn::LowerHalf(half, steps.right_px), hn::LowerHalf(half, steps.down_px));
    if (count_px <= kRows) {
      return {hn::ZeroExtendVector(d, lower.u), hn::ZeroExtendVector(d, lower.v)};
    }
    const Half upper =
        half_at(hn::UpperHalf(half, steps.right_px), hn::UpperHalf(half, steps.down_px));
    return {hn::Combine(d, upper.u, lower.u), hn::Combine(d, upper.v, lower.v)};
  }

 private:
  struct Half {
    Columns u, v;
  };

  HWY_INLINE ExactProjectiveSmall(const ProjectiveSmalls& of, size_t i, const SmallTexels& texels,
                                  const SmallIntegerFrame& frame)
      : u_(of.u, i, frame.integers(TimesDepth{&selvage_vertex::u, texels.first_s}), texels.end_s),
        v_(of.v, i, frame.integers(TimesDepth{&selvage_vertex::v, texels.first_t}), texels.end_t),
        q_start_(of.q.start[i]),
        q_right_(of.q.right[i]),
        q_down_(of.q.down[i]),
        q_(frame.integers([](const selvage_vertex& vertex) { return int64_t{vertex.q}; })) {}

  [[nodiscard]] HWY_INLINE Half half_at(Columns right_px, Columns down_px) const {
    const RowTag d;
    const WideTag wide;
    const RowNumbers right = number(right_px), down = number(down_px);
    const RowNumbers across = hn::MulAdd(right, hn::Set(d, q_right_), hn::Set(d, q_start_));
    const RowNumbers q = hn::MulAdd(down, hn::Set(d, q_down_), across);
    constexpr double kUnit = 1.0 / (1 << kTexelFraction);
    const Wides x = hn::PromoteTo(wide, right_px), y = hn::PromoteTo(wide, down_px);
    const Wides divisor = hn::ShiftLeft<kTexelFraction>(q_.at(x, y));
    const RowNumbers reciprocal = hn::Div(hn::Set(d, kUnit), q);
    const ExactSmallForm::Pixels pixels{right, down, x, y, reciprocal, divisor};
    return {u_.texels_fx16(pixels), v_.texels_fx16(pixels)};
  }

  ExactSmallForm u_, v_;
  double q_start_, q_right_, q_down_;
  SmallIntegers q_;
};

#endif

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
