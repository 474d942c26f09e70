// Small triangles in perspective: their coordinates. Included once for each SIMD target.
//
// u q, v q and q are affine over the target: u is the quotient of the first and the last. Pixels'
// are found in single precision, with a reciprocal that is estimated and then bettered once;
// counted from a triangle's least texel, u is so small that this is precise enough. Lanes are 8.24,
// lowered by their error:
//
//     lane <= true value < lane + lack                            (spec/proofs/small_projective.g)
#if defined(SELVAGE_VECTOR_SMALL_PROJECTIVE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_SMALL_PROJECTIVE_INL_H
#undef SELVAGE_VECTOR_SMALL_PROJECTIVE_INL_H
#else
#define SELVAGE_VECTOR_SMALL_PROJECTIVE_INL_H
#endif

#include <cstddef>

#include "mapper/small_polygons.h"
#include "mapper/vector/kernel.h"
#include "mapper/vector/lanes-inl.h"
#include "mapper/vector/small_frame-inl.h"
#include "mapper/vector/small_shapes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

#if SELVAGE_DRAWS_SMALL

using SmallFloatTag = hn::RebindToFloat<ColumnTag>;
using PixelFloatTag = hn::RebindToFloat<D32>;
using PixelFloats = hn::Vec<PixelFloatTag>;

// u q, v q or q of triangles, each to be picked: at the part's first pixel, and from there to the
// right and down.
struct SmallForm {
  HWY_ALIGN double start[kRows], right[kRows], down[kRows];  // times the doubled area
  // Over the least q of the vertices; texels in units of 2^-24.
  HWY_ALIGN float unit_start[kRows], unit_right[kRows], unit_down[kRows];
};

struct AtVertices {
  RowNumbers a, b, c;

  [[nodiscard]] HWY_INLINE AtVertices times(const AtVertices& other) const {
    return {hn::Mul(a, other.a), hn::Mul(b, other.b), hn::Mul(c, other.c)};
  }
};

// q of kRows triangles from an index on; of fewer, the last one's again.
[[nodiscard]] HWY_INLINE AtVertices depths_of(const SmallPolygons& polygons, size_t first) {
  HWY_ALIGN int32_t q[3][kRows];
  for (size_t i = 0; i < size_t{kRows}; ++i) {
    const Polygon& polygon = polygons.polygon(HWY_MIN(first + i, polygons.count() - 1));
    for (size_t k = 0; k < 3; ++k) q[k][i] = polygon.vertices[k].q;
  }
  const ColumnTag d;
  return {number(hn::Load(d, q[0])), number(hn::Load(d, q[1])), number(hn::Load(d, q[2]))};
}

// Of kRows triangles.
class ProjectiveSmalls {
 public:
  SmallForm u, v, q;
  HWY_ALIGN float lowered_fx24[kRows];  // by so much are lanes

  HWY_INLINE void find(const SmallPolygons& polygons, size_t first, const SmallVertices& vertices,
                       const SmallFrame& frame, const SmallWindows& windows) {
    const RowTag d;
    polygons_ = &polygons;
    first_ = first;
    const AtVertices depths = depths_of(polygons, first);
    const RowNumbers least = hn::Min(hn::Min(depths.a, depths.b), depths.c);
    const RowNumbers unit = hn::Div(hn::Set(d, 1.0), hn::Mul(frame.doubled_area(), least));
    const RowNumbers fx24 = hn::Mul(unit, hn::Set(d, 1 << (kWindowFraction - kTexelFraction)));
    const Columns s = windows.s.texel, t = windows.t.texel;
    const auto& [a, b, c] = vertices;
    const AtVertices of_u{from_texel(a.u, s), from_texel(b.u, s), from_texel(c.u, s)},
        of_v{from_texel(a.v, t), from_texel(b.v, t), from_texel(c.v, t)};
    const RowNumbers most_q = put(frame, depths, unit, &q);
    const RowNumbers most_u = put(frame, of_u.times(depths), fx24, &u),
                     most_v = put(frame, of_v.times(depths), fx24, &v);
    find_errors(hn::Max(most_u, most_v), most_q, frame.doubled_area());
  }

  // Whether the lanes of one are what they should be.
  [[nodiscard]] HWY_INLINE bool has_lanes(size_t i) const { return (have_lanes_ >> i & 1) != 0; }
  // If so:
  [[nodiscard]] HWY_INLINE int32_t lack_fx24(size_t i) const { return lack_fx24_[i]; }

  // What it was set up from.
  [[nodiscard]] HWY_INLINE const Polygon& polygon(size_t i) const {
    return polygons_->polygon(first_ + i);
  }
  [[nodiscard]] HWY_INLINE int32_t first_px(size_t i) const {
    return polygons_->left_px()[first_ + i];
  }
  [[nodiscard]] HWY_INLINE int32_t first_row(size_t i) const {
    return polygons_->first_row()[first_ + i];
  }

 private:
  // Returns the most that it can be, in that unit: the sum of its terms without their signs.
  static HWY_INLINE RowNumbers put(const SmallFrame& frame, const AtVertices& of, RowNumbers unit,
                                   SmallForm* to) {
    const RowTag d;
    const SmallFloatTag floats;
    const SmallFrame::Gradient gradient = frame.gradient(of.a, of.b, of.c);
    const RowNumbers start = frame.at_first_pixel(of.a, gradient),
                     right = hn::Mul(gradient.along_x, hn::Set(d, kSubpixels)),
                     down = hn::Mul(gradient.along_y, hn::Set(d, kSubpixels));
    hn::Store(start, d, to->start);
    hn::Store(right, d, to->right);
    hn::Store(down, d, to->down);
    const RowNumbers unit_start = hn::Mul(start, unit), unit_right = hn::Mul(right, unit),
                     unit_down = hn::Mul(down, unit);
    hn::Store(hn::DemoteTo(floats, unit_start), floats, to->unit_start);
    hn::Store(hn::DemoteTo(floats, unit_right), floats, to->unit_right);
    hn::Store(hn::DemoteTo(floats, unit_down), floats, to->unit_down);
    const RowNumbers across = hn::Add(hn::Abs(unit_right), hn::Abs(unit_down));
    return hn::MulAdd(across, hn::Set(d, kSmall.most_px - 1), hn::Abs(unit_start));
  }
  HWY_INLINE void find_errors(RowNumbers most_texel, RowNumbers most_q, RowNumbers doubled_area) {
    const RowTag d;
    const RowNumbers error =
        hn::MulAdd(hn::Mul(most_texel, most_q), hn::Set(d, kSmallRoundings * 0x1p-24),
                   hn::Set(d, kSmallSlack_fx24));
    hn::Store(hn::DemoteTo(SmallFloatTag(), error), SmallFloatTag(), lowered_fx24);
    const RowNumbers lack = hn::MulAdd(error, hn::Set(d, 2.0), hn::Set(d, kSmallTruncations_fx24));
    hn::Store(hn::DemoteTo(ColumnTag(), lack), ColumnTag(), lack_fx24_);
    const auto are_precise = hn::And(hn::Le(error, hn::Set(d, kMostSmallError_fx24)),
                                     hn::Le(most_q, hn::Set(d, kMostSmallDepth)));
    const auto are_whole = hn::Ge(doubled_area, hn::Set(d, double{kLeastSmallArea}));
    have_lanes_ = bits_of(hn::And(are_precise, are_whole));
  }

  HWY_ALIGN int32_t lack_fx24_[kRows];
  uint32_t have_lanes_;  // a bit each
  const SmallPolygons* polygons_;
  size_t first_;
};

// Truncated; of what no lane holds any number.
[[nodiscard]] HWY_INLINE V32 truncated(PixelFloats value) {
#if HWY_TARGET == HWY_AVX3
  return V32{_mm512_cvttps_epi32(value.raw)};
#else
  return V32{_mm256_cvttps_epi32(value.raw)};
#endif
}

// u q, v q and q of pixels; u and v are lowered.
struct SmallParts {
  PixelFloats u, v, q;

  [[nodiscard]] HWY_INLINE LaneVectors lanes(PixelFloats lowered_fx24) const {
    const PixelFloatTag d;
    const PixelFloats estimate = hn::ApproximateReciprocal(q);
    const PixelFloats rest = hn::NegMulAdd(q, estimate, hn::Set(d, 1.0F));
    const PixelFloats reciprocal = hn::MulAdd(estimate, rest, estimate);
    return {truncated(hn::MulSub(u, reciprocal, lowered_fx24)),
            truncated(hn::MulSub(v, reciprocal, lowered_fx24))};
  }
};

// The lanes of one of them.
class ProjectiveSmallLanes {
 public:
  HWY_INLINE ProjectiveSmallLanes(const ProjectiveSmalls& of, size_t i)
      : u_(of.u, i),
        v_(of.v, i),
        q_(of.q, i),
        lowered_fx24_(hn::Set(PixelFloatTag(), of.lowered_fx24[i])) {}

  [[nodiscard]] HWY_INLINE SmallParts parts(const PixelSteps& steps) const {
    const PixelFloats right = hn::ConvertTo(PixelFloatTag(), steps.right_px),
                      down = hn::ConvertTo(PixelFloatTag(), steps.down_px);
    return {u_.at(right, down), v_.at(right, down), q_.at(right, down)};
  }
  [[nodiscard]] HWY_INLINE LaneVectors at(const PixelSteps& steps) const {
    return parts(steps).lanes(lowered_fx24_);
  }

 private:
  class Line {
   public:
    HWY_INLINE Line(const SmallForm& of, size_t i)
        : start_(hn::Set(PixelFloatTag(), of.unit_start[i])),
          right_(hn::Set(PixelFloatTag(), of.unit_right[i])),
          down_(hn::Set(PixelFloatTag(), of.unit_down[i])) {}

    [[nodiscard]] HWY_INLINE PixelFloats at(PixelFloats right_px, PixelFloats down_px) const {
      return hn::MulAdd(right_px, right_, hn::MulAdd(down_px, down_, start_));
    }

   private:
    PixelFloats start_, right_, down_;
  };

  Line u_, v_, q_;
  PixelFloats lowered_fx24_;
};

// The lanes of its rows, up to kLanes, that begin at some pixels.
class ProjectiveSmallRows {
 public:
  HWY_INLINE ProjectiveSmallRows(const ProjectiveSmalls& of, size_t i, const PixelSteps& begin) {
    const SmallParts first = ProjectiveSmallLanes(of, i).parts(begin);
    hn::Store(first.u, PixelFloatTag(), u_);
    hn::Store(first.v, PixelFloatTag(), v_);
    hn::Store(first.q, PixelFloatTag(), q_);
  }

  // From a row's first pixel on; kept in registers.
  class Walk {
   public:
    HWY_INLINE Walk(const ProjectiveSmalls& of, size_t i)
        : u_(walk(of.u, i)),
          v_(walk(of.v, i)),
          q_(walk(of.q, i)),
          lowered_fx24_(hn::Set(PixelFloatTag(), of.lowered_fx24[i])) {}

    // The first vector of the k-th row.
    [[nodiscard]] HWY_INLINE LaneVectors along(const ProjectiveSmallRows& rows, int32_t k) const {
      const PixelFloatTag d;
      const SmallParts parts{hn::Add(hn::Set(d, rows.u_[k]), u_),
                             hn::Add(hn::Set(d, rows.v_[k]), v_),
                             hn::Add(hn::Set(d, rows.q_[k]), q_)};
      return parts.lanes(lowered_fx24_);
    }

   private:
    static HWY_INLINE PixelFloats walk(const SmallForm& form, size_t i) {
      const PixelFloatTag d;
      return hn::Mul(hn::Iota(d, 0.0F), hn::Set(d, form.unit_right[i]));
    }

    PixelFloats u_, v_, q_, lowered_fx24_;
  };

 private:
  HWY_ALIGN float u_[kLanes], v_[kLanes], q_[kLanes];
};

#endif

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
