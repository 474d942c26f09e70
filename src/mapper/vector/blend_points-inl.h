// The points of the filters over four texels, kLanes pixels at a time: floor(256 (u - 1/2)) and
// floor(256 (v - 1/2)). Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_BLEND_POINTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BLEND_POINTS_INL_H
#undef SELVAGE_VECTOR_BLEND_POINTS_INL_H
#else
#define SELVAGE_VECTOR_BLEND_POINTS_INL_H
#endif

#include "mapper/filter_point.h"
#include "mapper/vector/near_ties-inl.h"
#include "mapper/vector/projective_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

struct PointVectors {
  V32 u_fx8, v_fx8;
};

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
  HWY_INLINE AffinePoints(const AffineSteps& steps, int32_t px, int32_t row, RowOfTies* ties)
      : ties_(ties),
        margin_fx32_(steps.spans.field.margin_fx32),
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
  // Of the pixels from here on.
  HWY_INLINE PointVectors points() const {
    const D32 d;
    const GridLanes nearest{u_.floor_fx8, hn::Max(u_.below_fx32, v_.below_fx32)};
    if (HWY_LIKELY(hn::AllFalse(d, nearest.near(margin_fx32_)))) {
      return {u_.floor_fx8, v_.floor_fx8};
    }
    return decided(ties_, px_, margin_fx32_, u_, v_);
  }

 private:
  static HWY_INLINE Lane first(const AffineSteps& steps, int32_t px, int32_t row) {
    constexpr int64_t kHalf_fx32 = int64_t{1} << (kLaneFraction - 1);
    const Lane lane = steps.spans.field.at(px, row);
    return {lane.u_fx32 - kHalf_fx32, lane.v_fx32 - kHalf_fx32};
  }

  // All by value, so that the loop keeps its lanes in registers.
  static HWY_NOINLINE PointVectors decided(RowOfTies* ties, int32_t px, uint32_t margin_fx32,
                                           GridLanes u, GridLanes v) {
    const D32 d;
    const V32 half = hn::Set(d, kTexel_fx8 / 2);
    V32 u_fx8 = hn::Add(u.floor_fx8, half), v_fx8 = hn::Add(v.floor_fx8, half);
    ties->decide(px - ties->span().left_px, {u.near(margin_fx32), v.near(margin_fx32)}, &u_fx8,
                 &v_fx8);
    return {hn::Sub(u_fx8, half), hn::Sub(v_fx8, half)};
  }

  RowOfTies* ties_;
  uint32_t margin_fx32_;
  int32_t px_;
  GridLanes step_u_, step_v_, u_, v_;
};

class ProjectivePoints;

struct ProjectiveSteps {
  using Points = ProjectivePoints;

  HWY_INLINE ProjectiveSteps(const ProjectiveSpans& spans, const Span& span)
      : left_px(span.left_px), row(spans.field.of(span), kTexel_fx8) {}

  int32_t left_px;
  ProjectiveRow row;
};

// Walks along one row in perspective.
class ProjectivePoints {
 public:
  HWY_INLINE ProjectivePoints(const ProjectiveSteps& steps, int32_t px, int32_t /*row*/,
                              RowOfTies* ties)
      : steps_(steps), px_(px), ties_(ties) {}

  HWY_INLINE void advance() { px_ += kLanes; }
  HWY_INLINE PointVectors points() const {
    const V32 half = hn::Set(D32(), kTexel_fx8 / 2);
    const int32_t offset_px = px_ - steps_.left_px;
    LowTexels low = steps_.row.low(offset_px);
    if (HWY_UNLIKELY(low.near_u || low.near_v)) {
      ties_->decide(offset_px, steps_.row.near(offset_px, low), &low.s, &low.t);
    }
    return {hn::Sub(low.s, half), hn::Sub(low.t, half)};
  }

 private:
  const ProjectiveSteps& steps_;
  int32_t px_;
  RowOfTies* ties_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
