// Spans of which each has a map of its own, by windows and by strips. Included once for each SIMD
// target.
//
// Vectors begin with their rows' lanes, and go on by one step for all, the least of the rows' steps
// of each coordinate:
//
//     lane <= true value < lane + margin + (kLanes - 1) (greatest step - least one)
//                                                               (spec/proofs/common_step.g)
//
// which leaves little in doubt where rows are those of a polygon that nearly lies in a plane, as
// those do whose corners were rounded to the grid.
#if defined(SELVAGE_VECTOR_RULED_STRIPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_RULED_STRIPS_INL_H
#undef SELVAGE_VECTOR_RULED_STRIPS_INL_H
#else
#define SELVAGE_VECTOR_RULED_STRIPS_INL_H
#endif

#include <bit>
#include <optional>

#include "mapper/vector/affine_narrow-inl.h"
#include "mapper/vector/ruled_window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Anchors of kLanes rows at a time, of vectors that begin at some pixels of them.
class RuledAnchors {
 public:
  class Lines {
   public:
    HWY_INLINE Lines(const RuledAnchors& of, int32_t row) : of_(of), row_(row) {}

    // Goes down to the rows below.
    HWY_INLINE WidePair next(V32 px) {
      const hn::Half<D32> half;
      const V32 left_px = hn::LoadU(D32(), of_.spans_->batch.left_px.data() + row_);
      const V32 offset_px = hn::Sub(px, left_px);
      const RuledLanes low = at(hn::PromoteTo(Wide(), hn::LowerHalf(half, offset_px)));
      const RuledLanes high = at(hn::PromoteTo(Wide(), hn::UpperHalf(half, offset_px)));
      return {{hn::BitCast(D32(), low.u), hn::BitCast(D32(), high.u)},
              {hn::BitCast(D32(), low.v), hn::BitCast(D32(), high.v)}};
    }

   private:
    HWY_INLINE RuledLanes at(WideVector offset_px) {
      const auto row = static_cast<size_t>(row_);
      const RuledLanes start = RuledLanes::of(of_.spans_->rows.start.data() + row);
      const RuledLanes step = RuledLanes::of(of_.spans_->rows.step.data() + row);
      row_ += kLanes / 2;
      const auto sum = [&](WideVector from, WideVector by, int64_t to_anchor) HWY_ATTR {
        const WideVector first = hn::Add(from, hn::Set(Wide(), to_anchor));
        return hn::Add(first, PixelWalk(by).by(offset_px));
      };
      return {sum(start.u, step.u, of_.to_anchor_.u_fx32),
              sum(start.v, step.v, of_.to_anchor_.v_fx32)};
    }

    const RuledAnchors& of_;
    int32_t row_;
  };

  HWY_INLINE RuledAnchors(const RuledSpans& spans, Lane to_anchor)
      : spans_(&spans), to_anchor_(to_anchor) {}

  // From a row of the batch on.
  [[nodiscard]] HWY_INLINE Lines from(int32_t row) const { return {*this, row}; }

 private:
  const RuledSpans* spans_;
  Lane to_anchor_;
};

// What lanes of vectors' last pixels may lack by it, 1/512 texel: by more, near-ties would be many.
inline constexpr int64_t kMostDrift_fx32 = int64_t{1} << (kLaneFraction - 9);

// The step of all rows and the margin, the only numbers of a field that vectors ask for once they
// have their anchors; empty where steps are too far apart. That of a row of one pixel or none means
// nothing, and what is behind the batch's last row even less.
[[nodiscard]] HWY_INLINE std::optional<AffineField> common_steps(const RuledSpans& spans) {
  const Wide d;
  const hn::Half<D32> half;
  const WideVector none_least = hn::Set(d, INT64_MAX), none_most = hn::Set(d, INT64_MIN);
  RuledLanes least{none_least, none_least}, most{none_most, none_most};
  for (int32_t i = 0; i < spans.batch.rows; i += kLanes / 2) {
    const RuledLanes step = RuledLanes::of(spans.rows.step.data() + i);
    const auto width = hn::Sub(hn::LoadU(half, spans.batch.right_px.data() + i),
                               hn::LoadU(half, spans.batch.left_px.data() + i));
    const auto has_row = hn::Lt(hn::Iota(half, i), hn::Set(half, spans.batch.rows));
    const auto width_px = hn::PromoteTo(d, hn::IfThenElseZero(has_row, width));
    const auto has_step = hn::Gt(width_px, hn::Set(d, 1));
    least.u = hn::Min(least.u, hn::IfThenElse(has_step, step.u, least.u));
    least.v = hn::Min(least.v, hn::IfThenElse(has_step, step.v, least.v));
    most.u = hn::Max(most.u, hn::IfThenElse(has_step, step.u, most.u));
    most.v = hn::Max(most.v, hn::IfThenElse(has_step, step.v, most.v));
  }
  const auto least_of = [](WideVector of)
                            HWY_ATTR { return hn::GetLane(hn::MinOfLanes(Wide(), of)); };
  const auto most_of = [](WideVector of)
                           HWY_ATTR { return hn::GetLane(hn::MaxOfLanes(Wide(), of)); };
  const Lane from{least_of(least.u), least_of(least.v)}, to{most_of(most.u), most_of(most.v)};
  if (from.u_fx32 > to.u_fx32) return std::nullopt;
  const int64_t apart_fx32 = HWY_MAX(to.u_fx32 - from.u_fx32, to.v_fx32 - from.v_fx32);
  const int64_t drift_fx32 = (kLanes - 1) * apart_fx32;
  if (drift_fx32 > kMostDrift_fx32) return std::nullopt;
  const auto margin_fx32 = spans.rows.margin_fx32 + static_cast<uint32_t>(drift_fx32);
  return AffineField{0, spans.batch.first_row, {}, from, {}, margin_fx32};
}
// 15 differences of steps fit 64 bits.
inline constexpr int kStepBits = kTexelBits - kTexelFraction + 2 + kLaneFraction;
static_assert(kStepBits + 1 + std::bit_width(static_cast<uint32_t>(kMostLanes)) < 63);

// Whether near-ties are decided by few bits, as they are but for edges of some thousand pixels:
// otherwise that would cost more than six times what window strips do.
[[nodiscard]] HWY_INLINE bool has_short_ties(const RuledSpans& spans) {
  constexpr int kMostBits = OneLimb::kBits - 4;
  return are_enough(kMostBits, spans.rows.most_denominator,
                    spare_bits_fx16(lack_fx16(spans.rows.margin_fx32)));
}

// Draws a batch from windows, but for vectors that rest->draw() draws. False where rows have no
// windows that are alike. Few rows, too: one by one they cost more than those of a plane.
template <class Pixel>
[[nodiscard]] HWY_INLINE bool draw_window_strips(const RuledSpans& spans, const Surface& surface,
                                                 RestDraw* rest) {
  if (!may_have_windows(surface.texture) || spans.batch.widest_px > kMostWindowStrips_px ||
      !has_short_ties(spans)) {
    return false;
  }
  const std::optional<AffineField> field = common_steps(spans);
  if (!field) return false;
  const WindowShape shape = window_shape(field->step_x, surface.texture);
  if (shape.rows == 0) return false;
  const AffineSpans affine{spans.batch, *field, spans.texels, spans.exact};
  const bool inside = TexelRanges(spans.texels).within(surface.texture);
  const RuledAnchors anchors(spans, way_to_anchor(field->step_x));
  with_window_shape<Pixel>(surface, shape, inside,
                           WindowStrips<RuledAnchors>{affine, anchors, surface, inside, rest});
  return true;
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
