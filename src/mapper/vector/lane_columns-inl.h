// Affine lanes at a pixel of each of kLanes rows: a lane is a row, a step goes to the right.
// Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_LANE_COLUMNS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_LANE_COLUMNS_INL_H
#undef SELVAGE_VECTOR_LANE_COLUMNS_INL_H
#else
#define SELVAGE_VECTOR_LANE_COLUMNS_INL_H
#endif

#include "mapper/affine_slab.h"
#include "mapper/vector/affine_lanes-inl.h"
#include "mapper/vector/affine_strip-inl.h"
#include "mapper/vector/limbs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// One coordinate's lanes at a pixel of each of kLanes rows, and their steps to the next ones.
class LaneColumn {
 public:
  HWY_INLINE LaneColumn(const WideLanes& at_fx32, const WideLanes& step_fx32)
      : at_(at_fx32), step_(step_fx32) {}

  [[nodiscard]] HWY_INLINE V32 floors_fx16() const { return at_.floors_fx16(); }
  HWY_INLINE void go_right() { at_ = {sum(at_.low, step_.low), sum(at_.high, step_.high)}; }

 private:
  static HWY_INLINE V32 sum(V32 at, V32 step) {
    return hn::BitCast(D32(), hn::Add(hn::BitCast(D64(), at), hn::BitCast(D64(), step)));
  }

  WideLanes at_, step_;
};
struct LaneColumns {
  LaneColumn u, v;

  [[nodiscard]] HWY_INLINE LaneVectors get() const { return {u.floors_fx16(), v.floors_fx16()}; }
  HWY_INLINE void go_right() {
    u.go_right();
    v.go_right();
  }
};

// Those of a plane's rows.
class PlaneColumns {
 public:
  explicit HWY_INLINE PlaneColumns(const AffineField& field) : field_(field) {}

  // From pixels of kLanes rows on, which are not negative.
  [[nodiscard]] HWY_INLINE LaneColumns from(int32_t row, V32 px) const {
    const Lane start = field_.at(0, row), right = field_.step_x, down = field_.step_y;
    const auto column = [&](int64_t start_fx32, int64_t right_fx32, int64_t down_fx32) HWY_ATTR {
      const V32 step = hn::BitCast(D32(), hn::Set(D64(), static_cast<uint64_t>(right_fx32)));
      return LaneColumn(WideAnchorLine(start_fx32, right_fx32, down_fx32).next(px), {step, step});
    };
    return {column(start.u_fx32, right.u_fx32, down.u_fx32),
            column(start.v_fx32, right.v_fx32, down.v_fx32)};
  }

 private:
  AffineField field_;
};

// Those of rows that each have a map of their own.
class RuledColumns {
 public:
  HWY_INLINE RuledColumns(const RuledRows& rows, const SpanBatch& batch)
      : rows_(rows), batch_(batch) {}

  // From the rows' first pixels on.
  [[nodiscard]] HWY_INLINE LaneColumns from(int32_t row, V32 /*px*/) const {
    HWY_ALIGN int64_t start_u[kLanes]{}, start_v[kLanes]{}, step_u[kLanes]{}, step_v[kLanes]{};
    const int32_t index = row - batch_.first_row, count = HWY_MIN(kLanes, batch_.rows - index);
    for (int32_t k = 0; k < count; ++k) {
      const auto i = static_cast<size_t>(index + k);
      start_u[k] = rows_.start[i].u_fx32;
      start_v[k] = rows_.start[i].v_fx32;
      step_u[k] = rows_.step[i].u_fx32;
      step_v[k] = rows_.step[i].v_fx32;
    }
    return {{wide(start_u), wide(step_u)}, {wide(start_v), wide(step_v)}};
  }

 private:
  static HWY_INLINE WideLanes wide(const int64_t* lanes_fx32) {
    const hn::RebindToSigned<D64> d;
    return {hn::BitCast(D32(), hn::Load(d, lanes_fx32)),
            hn::BitCast(D32(), hn::Load(d, lanes_fx32 + kLanes / 2))};
  }

  const RuledRows& rows_;
  const SpanBatch& batch_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
