// Affine spans of a polygon whose texels lie in one window. Included once for each SIMD target.
//
// With fine_lack_fx24 and its steps
//
//     lane <= true value < lane + lack                                  (spec/proofs/fine_lanes.g)
//
// in 2^-24 texel, modulo 2^32: the texels are less than half of 2^8 from the window's origin.
#if defined(SELVAGE_VECTOR_AFFINE_WINDOW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#undef SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_WINDOW_INL_H
#endif

#include "mapper/vector/affine_exact-inl.h"
#include "mapper/vector/affine_strip-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Of rows that one window holds, lanes of 8.24 modulo 2^32, counted from its origin.
class LowFineLanes {
 public:
  static constexpr int kFraction = kWindowFraction;

  explicit HWY_INLINE LowFineLanes(int32_t lack_fx24) : low_(lack_fx24) {}

  // What adding all that they may lack changes in either lane: above the low 24 bits, texels.
  [[nodiscard]] HWY_INLINE V32 changes(const LaneVectors& lanes) const {
    return low_.changes(lanes);
  }

 private:
  LowLanes low_;  // no fraction enters there
};

// One coordinate of their anchors, of kLanes rows at a time, of vectors that begin at some pixels
// of them.
class FineAnchorLine {
 public:
  // `first_fx24`: that of the first row's vector that begins at pixel 0.
  HWY_INLINE FineAnchorLine(uint32_t first_fx24, int32_t step_x_fx24, int32_t step_y_fx24)
      : step_(hn::Set(D32(), step_x_fx24)), down_(hn::Set(D32(), step_y_fx24)) {
    const V32 rows = hn::Mul(hn::Iota(D32(), 0), down_);
    rows_ = hn::Add(hn::Set(D32(), static_cast<int32_t>(first_fx24)), rows);
    down_ = hn::ShiftLeft<kLanesLog2>(down_);
  }

  // Goes down to the rows below.
  HWY_INLINE V32 next(V32 px) {
    const V32 anchors = hn::Add(rows_, hn::Mul(px, step_));
    rows_ = hn::Add(rows_, down_);
    return anchors;
  }

 private:
  static constexpr int kLanesLog2 = kLanes == 16 ? 4 : kLanes == 8 ? 3 : 2;
  static_assert(1 << kLanesLog2 == kLanes);

  V32 step_, down_, rows_;
};

class FineAnchors {
 public:
  struct Lines {
    struct Anchors {
      V32 u, v;
    };
    HWY_INLINE Anchors next(V32 px) { return {u.next(px), v.next(px)}; }

    FineAnchorLine u, v;
  };

  // `anchor`: of the vector that begins at pixel `px` of the batch's first row.
  HWY_INLINE FineAnchors(const AffineField& field, int32_t px, Lane anchor)
      : step_x_(in_fx24(field.step_x)),
        step_y_(in_fx24(field.step_y)),
        first_(from(in_fx24(anchor), -px, step_x_)) {}

  // From a row of the batch on.
  HWY_INLINE Lines from(int32_t row) const {
    const Fine first = from(first_, row, step_y_);
    return {FineAnchorLine(first.u, signed_of(step_x_.u), signed_of(step_y_.u)),
            FineAnchorLine(first.v, signed_of(step_x_.v), signed_of(step_y_.v))};
  }

 private:
  // Floors, modulo 2^32.
  struct Fine {
    uint32_t u, v;
  };
  static HWY_INLINE Fine in_fx24(Lane lane) {
    return {static_cast<uint32_t>(lane.u_fx32 >> kWindowShift),
            static_cast<uint32_t>(lane.v_fx32 >> kWindowShift)};
  }
  static HWY_INLINE Fine from(Fine start, int32_t steps, Fine step) {
    const auto count = static_cast<uint32_t>(steps);
    return {start.u + count * step.u, start.v + count * step.v};
  }
  static HWY_INLINE int32_t signed_of(uint32_t fx24) { return static_cast<int32_t>(fx24); }

  Fine step_x_, step_y_, first_;
};

struct FineStrip : Strip {
  HWY_ALIGN int32_t u_fx24[kRowsPerBatch + kLanes], v_fx24[kRowsPerBatch + kLanes];

  HWY_INLINE void put(int32_t row, const StripEnds& ends, const FineAnchors::Lines::Anchors& at) {
    Strip::put(row, ends);
    hn::StoreU(at.u, D32(), u_fx24 + row);
    hn::StoreU(at.v, D32(), v_fx24 + row);
  }
};

// Under one map.
class FineLanes : public LowFineLanes {
 public:
  HWY_INLINE FineLanes(Lane step_x, int32_t lack_fx24)
      : LowFineLanes(lack_fx24),
        offset_u_(offsets_from_anchor<kWindowShift>(step_x.u_fx32)),
        offset_v_(offsets_from_anchor<kWindowShift>(step_x.v_fx32)) {}

  HWY_INLINE LaneVectors of(const FineStrip& strip, int32_t row) const {
    const D32 d;
    return {hn::Add(hn::Set(d, strip.u_fx24[row]), offset_u_),
            hn::Add(hn::Set(d, strip.v_fx24[row]), offset_v_)};
  }

 private:
  V32 offset_u_, offset_v_;
};

static_assert(kPlaneErrorPerStep_fx32 == 1, "a plane's margin counts its steps");

// How many steps right and down there are to a pixel of the batch from the field's first column in
// its first row, at most. Those of the whole field, a plane's, are enough where they are few.
[[nodiscard]] HWY_INLINE int32_t steps_within(const AffineSpans& spans) {
  constexpr uint32_t kFew = 256;
  if (HWY_LIKELY(spans.field.margin_fx32 <= kFew)) {
    return static_cast<int32_t>(spans.field.margin_fx32);
  }
  int32_t right_px = INT32_MIN;
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    right_px = HWY_MAX(right_px, spans.batch.span(i).right_px);
  }
  return right_px - spans.field.first_px + spans.batch.rows;
}

// Draws vectors from one window, and keeps what the lanes of pixels lack changes in them. Lanes are
// those that lanes.of(strip, row) tells.
template <class Pixel, class OneWindow, class Lanes>
struct WindowPainter {
  static constexpr bool kTellsWhole = !kHasMask;  // by a mask a part costs no more than all

  OneWindow window;
  Lanes lanes;
  V32 changed = hn::Zero(D32());

  template <class AnyStrip>
  HWY_INLINE bool draw(const AnyStrip& strip, int32_t row, int32_t count_px, Pixel* to) {
    changed = draw_some(window, lanes, lanes.of(strip, row), count_px, changed, to);
    return true;
  }
  template <class AnyStrip>
  HWY_INLINE bool draw(const AnyStrip& strip, int32_t row, WholeVector /*count_px*/, Pixel* to) {
    changed = draw_whole(window, lanes, lanes.of(strip, row), changed, to);
    return true;
  }
  // Whether there is a near-tie: all are drawn once more then.
  [[nodiscard]] HWY_INLINE bool is_in_vain() const {
    return changes_texels<kWindowFraction>(changed);
  }
};

// For who leaves nothing.
struct NoRest {
  static HWY_INLINE bool draw(const Left& /*left*/, int32_t /*first_index*/,
                              int32_t /*of_vectors*/) {
    return true;
  }
};

// Returns what the lanes of pixels lack changes in them, those that were drawn up to a near-tie.
template <class Pixel, class OneWindow>
[[nodiscard]] HWY_INLINE V32 draw_from(const OneWindow& window, const AffineSpans& spans,
                                       const Surface& surface) {
  const AffineField field = spans.field;
  const FineLanes lanes(field.step_x, fine_lack_fx24(steps_within(spans), field.margin_fx32));
  const Lane first = plus(field.at(field.first_px, spans.batch.first_row), -1, window.origin());
  const FineAnchors anchors(field, field.first_px, plus(first, 1, way_to_anchor(field.step_x)));
  FineStrip strip;
  NoRest none;
  const WindowPainter<Pixel, OneWindow, FineLanes> painter{window, lanes};
  return draw_strips<Pixel>(painter, &strip, anchors, spans.batch, surface, &none).changed;
}

// Whether lanes of 8.24 tell the texels: those of a window that was clamped may be far from it.
[[nodiscard]] HWY_INLINE bool are_near(const TexelBox& box, Lane origin) {
  constexpr int32_t kNear_texel = 64;
  const TexelRanges texels(box);
  const auto within = [](const TexelRange& range, int64_t from_fx32) {
    const int32_t from = floor_texel(from_fx32);
    return range.first >= from - kNear_texel && range.last < from + kNear_texel;
  };
  return within(texels.s, origin.u_fx32) && within(texels.t, origin.v_fx32);
}

// Draws a batch by draw_from(), if a window is near its texels.
template <class Pixel, class Spans>
struct FromWindow {
  static constexpr bool kTwoSizes = false;

  const Spans& spans;
  const Surface& surface;
  V32* changed;  // by near-ties

  template <class OneWindow>
  [[nodiscard]] HWY_INLINE bool operator()(const OneWindow& window) const {
    if (OneWindow::kClamps && !are_near(spans.texels, window.origin())) return false;
    *changed = draw_from<Pixel>(window, spans, surface);
    return true;
  }
};

// Draws a batch, if one window holds its texels and no pixel is a near-tie.
template <class Pixel, class Address, class Spans>
[[nodiscard]] HWY_INLINE InOneWindow draw_one_window(const Spans& spans, const Surface& surface) {
  if (!pays_one_window(spans.batch)) return InOneWindow::kNotInOne;
  V32 changed;
  if (!with_one_window<Pixel, Address>(spans.texels, surface.texture,
                                       FromWindow<Pixel, Spans>{spans, surface, &changed})) {
    return InOneWindow::kNotInOne;
  }
  return in_one_window<kWindowFraction>(changed, spans.batch.widest_px);
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
