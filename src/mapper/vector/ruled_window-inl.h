// Spans of which each has a map of its own, from one window. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_RULED_WINDOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_RULED_WINDOW_INL_H
#undef SELVAGE_VECTOR_RULED_WINDOW_INL_H
#else
#define SELVAGE_VECTOR_RULED_WINDOW_INL_H
#endif

#include <cstddef>

#include "mapper/vector/affine_window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Both coordinates of some rows' lanes.
struct RuledLanes {
  WideVector u, v;

  static HWY_INLINE RuledLanes of(const Lane* rows) {
    static_assert(sizeof(Lane) == sizeof(int64_t[2]) && offsetof(Lane, v_fx32) == sizeof(int64_t));
    WideVector u, v;
    hn::LoadInterleaved2(Wide(), &rows->u_fx32, u, v);
    return {u, v};
  }
};

// Of one coordinate, of kLanes rows.
struct FineSteps {
  V32 first_fx24, step_fx24;
};

// Of kLanes rows, floors in 2^-24 texel, modulo 2^32.
struct FinePair {
  V32 u, v;

  static HWY_INLINE FinePair of(const Lane* rows) {
    const RuledLanes low = RuledLanes::of(rows), high = RuledLanes::of(rows + kLanes / 2);
    const auto floors = [](WideVector first, WideVector second) HWY_ATTR {
      return WideLanes{hn::BitCast(D32(), first), hn::BitCast(D32(), second)}
          .template floors<kWindowShift>();
    };
    return {floors(low.u, high.u), floors(low.v, high.v)};
  }
};

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
      const FinePair start = FinePair::of(spans.rows.start.data() + row_);
      const FinePair step = FinePair::of(spans.rows.step.data() + row_);
      row_ += kLanes;
      // An origin is a whole number of texels.
      const auto from = [&](V32 start_fx24, int32_t origin_fx24, V32 step_fx24) HWY_ATTR {
        const V32 first_fx24 = hn::Sub(start_fx24, hn::Set(D32(), origin_fx24));
        return FineSteps{hn::Add(first_fx24, hn::Mul(offset_px, step_fx24)), step_fx24};
      };
      return {from(start.u, of_.origin_u_fx24_, step.u), from(start.v, of_.origin_v_fx24_, step.v)};
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
