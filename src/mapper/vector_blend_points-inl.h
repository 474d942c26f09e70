// The points of the filters over four texels, kLanes pixels at a time: floor(256 (u - 1/2)) and
// floor(256 (v - 1/2)). Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_BLEND_POINTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BLEND_POINTS_INL_H
#undef SELVAGE_VECTOR_BLEND_POINTS_INL_H
#else
#define SELVAGE_VECTOR_BLEND_POINTS_INL_H
#endif

#include "mapper/filter_point.h"
#include "mapper/vector_kernel-inl.h"
#include "mapper/vector_projective_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

struct PointVectors {
  V32 u_fx8, v_fx8;
};

// The exact row in units of the grid, so that its texels are points.
[[nodiscard]] inline ExactRow on_grid(const ExactRow& row) {
  const auto finer = [](uint128 a) {
    return static_cast<uint128>(static_cast<int128>(a) >> kGridBits);  // a multiple of 2^16
  };
  return {row.u, row.v, {finer(row.d.start), finer(row.d.step)}};
}

inline constexpr int32_t kBelowGrid = (1 << kGridFraction) - 1;

// 32.32 lanes whole, in two vectors: floors on the grid, modulo 2^32, and what is below the grid.
struct GridLanes {
  V32 floor_fx8, below_fx32;

  static HWY_INLINE GridLanes all(int64_t lane_fx32) {
    return {hn::Set(D32(), static_cast<int32_t>(lane_fx32 >> kGridFraction)),
            hn::Set(D32(), static_cast<int32_t>(lane_fx32 & kBelowGrid))};
  }
  // Lane i gets i steps.
  static HWY_INLINE GridLanes walk(int64_t step_fx32) {
    HWY_ALIGN int32_t floor[kLanes], below[kLanes];
    for (int32_t i = 0; i < kLanes; ++i) {
      floor[i] = static_cast<int32_t>(i * step_fx32 >> kGridFraction);
      below[i] = static_cast<int32_t>(i * step_fx32 & kBelowGrid);
    }
    return {hn::Load(D32(), floor), hn::Load(D32(), below)};
  }
  // Whether what a lane may lack reaches the next step of the grid.
  HWY_INLINE hn::Mask<D32> near(uint32_t margin_fx32) const {
    return hn::Gt(below_fx32, hn::Set(D32(), kBelowGrid - static_cast<int32_t>(margin_fx32)));
  }
  HWY_INLINE GridLanes operator+(const GridLanes& other) const {
    const V32 sum = hn::Add(below_fx32, other.below_fx32);
    return {hn::Add(hn::Add(floor_fx8, other.floor_fx8), hn::ShiftRight<kGridFraction>(sum)),
            hn::And(sum, hn::Set(D32(), kBelowGrid))};
  }
};

static_assert(kWidestMargin_fx32 < int64_t{1} << 31);

class AffinePoints;

// How lanes go on from a vector's first one, and from vector to vector.
struct AffineSteps {
  using Points = AffinePoints;

  HWY_INLINE explicit AffineSteps(const AffineSpans& of)
      : spans(of),
        walk_u(GridLanes::walk(of.field.step_x.u_fx32)),
        walk_v(GridLanes::walk(of.field.step_x.v_fx32)),
        step_u(GridLanes::all(kLanes * of.field.step_x.u_fx32)),
        step_v(GridLanes::all(kLanes * of.field.step_x.v_fx32)) {}

  const AffineSpans& spans;
  GridLanes walk_u, walk_v, step_u, step_v;
};

// Walks along a row under one affine map. Lanes are of u - 1/2 and v - 1/2.
class AffinePoints {
 public:
  HWY_INLINE AffinePoints(const AffineSteps& steps, int32_t px, int32_t row)
      : spans_(steps.spans),
        margin_fx32_(steps.spans.field.margin_fx32),
        row_(row),
        px_(px),
        step_u_(steps.step_u),
        step_v_(steps.step_v),
        u_(GridLanes::all(first(steps, px, row).u_fx32) + steps.walk_u),
        v_(GridLanes::all(first(steps, px, row).v_fx32) + steps.walk_v) {}

  HWY_INLINE void advance() {
    px_ += kLanes;
    u_ = u_ + step_u_;
    v_ = v_ + step_v_;
  }
  // Of the pixels from here on; the first `count` mean something.
  HWY_INLINE PointVectors points(int32_t count) const {
    const D32 d;
    const GridLanes nearest{u_.floor_fx8, hn::Max(u_.below_fx32, v_.below_fx32)};
    if (HWY_LIKELY(hn::AllFalse(d, nearest.near(margin_fx32_)))) {
      return {u_.floor_fx8, v_.floor_fx8};
    }
    return decided(spans_, px_, row_, u_, v_, first_bits(count));
  }

 private:
  static HWY_INLINE Lane first(const AffineSteps& steps, int32_t px, int32_t row) {
    constexpr int64_t kHalf_fx32 = int64_t{1} << (kLaneFraction - 1);
    const Lane lane = steps.spans.field.at(px, row);
    return {lane.u_fx32 - kHalf_fx32, lane.v_fx32 - kHalf_fx32};
  }

  // All by value, so that the loop keeps its lanes in registers.
  static HWY_NOINLINE PointVectors decided(const AffineSpans& spans, int32_t px, int32_t row,
                                           GridLanes u, GridLanes v, uint32_t asked) {
    const D32 d;
    const ExactRow exact = on_grid(spans.exact.row_from(px, row));
    const V32 half = hn::Set(d, kTexel_fx8 / 2);
    const auto decided_of = [&](const GridLanes& lanes, const ExactLine& coordinate) {
      const uint32_t near = lane_bits(d, lanes.near(spans.field.margin_fx32)) & asked;
      return hn::Sub(decide(d, hn::Add(lanes.floor_fx8, half), near, exact, coordinate), half);
    };
    return {decided_of(u, exact.u), decided_of(v, exact.v)};
  }

  const AffineSpans& spans_;
  uint32_t margin_fx32_;
  int32_t row_, px_;
  GridLanes step_u_, step_v_, u_, v_;
};

class ProjectivePoints;

struct ProjectiveSteps {
  using Points = ProjectivePoints;

  HWY_INLINE ProjectiveSteps(const ProjectiveSpans& spans, const Span& of)
      : span(of), exact(spans.exact), row(spans.field.of(of), kTexel_fx8) {}

  const Span& span;
  const ExactMap& exact;
  ProjectiveRow row;
};

// Walks along one row in perspective.
class ProjectivePoints {
 public:
  HWY_INLINE ProjectivePoints(const ProjectiveSteps& steps, int32_t px, int32_t /*row*/)
      : steps_(steps), px_(px) {}

  HWY_INLINE void advance() { px_ += kLanes; }
  HWY_INLINE PointVectors points(int32_t count) const {
    const D32 d;
    const V32 half = hn::Set(d, kTexel_fx8 / 2);
    const LowTexels low = find(px_, HWY_MIN(count, kDoubles));
    const LowTexels high = find(px_ + kDoubles, HWY_MAX(count - kDoubles, 0));
    return {hn::Sub(hn::Combine(d, high.s, low.s), half),
            hn::Sub(hn::Combine(d, high.t, low.t), half)};
  }

 private:
  static_assert(2 * kDoubles == kLanes);

  HWY_INLINE LowTexels find(int32_t px, int32_t count) const {
    const DHalf d;
    uint32_t near_u, near_v;
    LowTexels low = steps_.row.low(px - steps_.span.left_px, &near_u, &near_v);
    near_u &= first_bits(count);
    near_v &= first_bits(count);
    if (HWY_UNLIKELY((near_u | near_v) != 0)) {
      const ExactRow exact = on_grid(steps_.exact.row_from(px, steps_.span.row));
      low.s = decide(d, low.s, near_u, exact, exact.u);
      low.t = decide(d, low.t, near_v, exact, exact.v);
    }
    return low;
  }

  const ProjectiveSteps& steps_;
  int32_t px_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
