// Spans of which each has a map of its own, from one window. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_RULED_WINDOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_RULED_WINDOW_INL_H
#undef SELVAGE_VECTOR_RULED_WINDOW_INL_H
#else
#define SELVAGE_VECTOR_RULED_WINDOW_INL_H
#endif

#include "mapper/vector/affine_window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Both coordinates of some rows' lanes.
struct RuledLanes {
  WideVector u, v;

  static HWY_INLINE RuledLanes of(const Lane* rows) {
    static_assert(sizeof(Lane) == sizeof(int64_t[2]));
    RuledLanes lanes;
    hn::LoadInterleaved2(Wide(), &rows->u_fx32, lanes.u, lanes.v);
    return lanes;
  }
};

// Of one coordinate, of kLanes rows.
struct FineSteps {
  V32 first_fx24, step_fx24;
};

// Floors in 2^-24 texel, modulo 2^32.
[[nodiscard]] HWY_INLINE V32 floors_fx24(WideVector low_fx32, WideVector high_fx32) {
  const auto shifted = [](WideVector lanes) HWY_ATTR {
    const hn::Repartition<uint64_t, D32> wide;
    return hn::BitCast(D32(), hn::ShiftRight<kWindowShift>(hn::BitCast(wide, lanes)));
  };
  return hn::ConcatEven(D32(), shifted(high_fx32), shifted(low_fx32));
}

// What vectors begin with that begin at some pixels of kLanes rows at a time, and their steps.
class RuledFineAnchors {
 public:
  class Lines {
   public:
    struct Anchors {
      FineSteps u, v;
    };

    HWY_INLINE Lines(const RuledFineAnchors& of, int32_t row) : of_(of), row_(row) {}

    // Goes down to the rows below.
    HWY_INLINE Anchors next(V32 px) {
      const RuledSpans& spans = *of_.spans_;
      const V32 offset_px = hn::Sub(px, hn::LoadU(D32(), spans.batch.left_px.data() + row_));
      const Lane* const start = spans.rows.start.data() + row_;
      const Lane* const step = spans.rows.step.data() + row_;
      row_ += kLanes;
      constexpr int32_t kHalf = kLanes / 2;
      const RuledLanes low = RuledLanes::of(start), high = RuledLanes::of(start + kHalf);
      const RuledLanes low_step = RuledLanes::of(step), high_step = RuledLanes::of(step + kHalf);
      const auto from = [&](V32 start_fx24, V32 step_fx24) HWY_ATTR {
        return FineSteps{hn::Add(start_fx24, hn::Mul(offset_px, step_fx24)), step_fx24};
      };
      // An origin is a whole number of texels.
      const V32 u = hn::Sub(floors_fx24(low.u, high.u), hn::Set(D32(), of_.origin_u_fx24_));
      const V32 v = hn::Sub(floors_fx24(low.v, high.v), hn::Set(D32(), of_.origin_v_fx24_));
      return {from(u, floors_fx24(low_step.u, high_step.u)),
              from(v, floors_fx24(low_step.v, high_step.v))};
    }

   private:
    const RuledFineAnchors& of_;
    int32_t row_;
  };

  // Counted from the origin.
  HWY_INLINE RuledFineAnchors(const RuledSpans& spans, Lane origin)
      : spans_(&spans),
        origin_u_fx24_(static_cast<int32_t>(origin.u_fx32 >> kWindowShift)),
        origin_v_fx24_(static_cast<int32_t>(origin.v_fx32 >> kWindowShift)) {}

  // From a row of the batch on.
  [[nodiscard]] HWY_INLINE Lines from(int32_t row) const { return {*this, row}; }

 private:
  const RuledSpans* spans_;
  int32_t origin_u_fx24_, origin_v_fx24_;
};

struct RuledFineStrip : FineStrip {
  HWY_ALIGN int32_t u_step_fx24[kRowsPerBatch + kLanes], v_step_fx24[kRowsPerBatch + kLanes];

  HWY_INLINE void put(int32_t row, const StripEnds& ends,
                      const RuledFineAnchors::Lines::Anchors& at) {
    FineStrip::put(row, ends, {at.u.first_fx24, at.v.first_fx24});
    hn::StoreU(at.u.step_fx24, D32(), u_step_fx24 + row);
    hn::StoreU(at.v.step_fx24, D32(), v_step_fx24 + row);
  }
};

// Each of its own step: low by less than a unit for each pixel from the span's first one on.
class RuledFineLanes : public LowFineLanes {
 public:
  explicit HWY_INLINE RuledFineLanes(int32_t lack_fx24) : LowFineLanes(lack_fx24) {}

  HWY_INLINE LaneVectors of(const RuledFineStrip& strip, int32_t row) const {
    const auto from = [](int32_t first_fx24, int32_t step_fx24) HWY_ATTR {
      const D32 d;
      return hn::Add(hn::Set(d, first_fx24), hn::Mul(hn::Iota(d, 0), hn::Set(d, step_fx24)));
    };
    return {from(strip.u_fx24[row], strip.u_step_fx24[row]),
            from(strip.v_fx24[row], strip.v_step_fx24[row])};
  }
};

// Returns what the lanes of pixels lack changes in them, those that were drawn up to a near-tie.
template <class Pixel, class OneWindow>
[[nodiscard]] HWY_INLINE V32 draw_from(const OneWindow& window, const RuledSpans& spans,
                                       const Surface& surface) {
  const RuledFineLanes lanes(fine_lack_fx24(spans.batch.widest_px, spans.rows.margin_fx32));
  const RuledFineAnchors anchors(spans, window.origin());
  RuledFineStrip strip;
  NoRest none;
  const WindowPainter<Pixel, OneWindow, RuledFineLanes> painter{window, lanes};
  return draw_strips<Pixel>(painter, &strip, anchors, spans.batch, surface, &none).changed;
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
