// Affine spans by windows, two rows at a time: where texels are some pixels wide, one window holds
// those of a vector and of the one below it. Included once for each SIMD target.
//
// Windows are found a run ahead: no processor foresees where the rows of a polygon end, and what is
// found by then need not be waited for.
#if defined(SELVAGE_VECTOR_AFFINE_WINDOW_PAIRS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_WINDOW_PAIRS_INL_H
#undef SELVAGE_VECTOR_AFFINE_WINDOW_PAIRS_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_WINDOW_PAIRS_INL_H
#endif

#include "mapper/vector/affine_window_runs-inl.h"
#include "mapper/vector/row_pairs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Whether windows of half as many columns as lanes hold all texels of two vectors, one below the
// other.
[[nodiscard]] HWY_INLINE bool holds_pairs(const AffineField& field,
                                          const selvage_texture& texture) {
  const auto texels = [&](int64_t Lane::*axis) {
    return texels_across((kLanes - 1) * magnitude_fx32(field.step_x.*axis) +
                         magnitude_fx32(field.step_y.*axis));
  };
  return may_have_windows(texture) && texture.height >= kHalfWindowRows &&
         texels(&Lane::u_fx32) <= kColumns<kHalfColumnBits> &&
         texels(&Lane::v_fx32) <= kHalfWindowRows;
}

// What a pair of rows costs beside its vectors, which cost little more than those of one row.
inline constexpr int32_t kPairCost_px = 5 * kLanes;

// `inside`: the texture holds all texels.
[[nodiscard]] HWY_INLINE bool pays_pairs(const AffineSpans& spans, const selvage_texture& texture,
                                         bool inside) {
  if (!kHasPairs || !inside || spans.batch.rows < 2 || !holds_pairs(spans.field, texture)) {
    return false;
  }
  int32_t by_rows_px = 0, by_pairs_px = 0;
  for (int32_t i = 0; i + 1 < spans.batch.rows; i += 2) {
    const Span upper = spans.batch.span(i), lower = spans.batch.span(i + 1);
    by_rows_px += upper.width_px() + lower.width_px();
    by_pairs_px += around(upper, lower).width_px() + kPairCost_px;
  }
  return by_pairs_px <= by_rows_px;
}

// Picks the texels of a vector and of the one below it.
template <class Pixel>
class PairPicker {
 public:
  using Coarse = CoarseLanes<kHalfColumnBits, kHalfWindowRows>;

  HWY_INLINE PairPicker(const AffineSpans& spans, const Surface& surface)
      : fixed_(surface.texture, lack_fx16(spans.field.margin_fx32)),
        to_anchor_(way_to_least(spans.field)),
        upper_{offsets(spans.field, -1)},
        lower_{offsets(spans.field, 1)},
        coarse_upper_(upper_, fixed_.lack_fx16()),
        coarse_lower_(lower_, fixed_.lack_fx16()),
        texels_(static_cast<const Pixel*>(surface.texture.texels)),
        pitch_texel_(pitch_texel_of(surface.texture)) {}

  // From the 32.32 lane of the upper vector's first pixel to the least one of both.
  [[nodiscard]] HWY_INLINE Lane to_anchor() const { return to_anchor_; }

  // False where one of their lanes, of a pixel or not, may be a near-tie.
  HWY_INLINE bool pick_both(const FoundWindows& found, int32_t k, V32* upper, V32* lower) const {
    auto [upper_index, upper_changes] = coarse_upper_.texels(found.coarse[k]);
    auto [lower_index, lower_changes] = coarse_lower_.texels(found.coarse[k]);
    if (HWY_UNLIKELY(Coarse::any_near(hn::Or(upper_changes, lower_changes)))) {
      const LaneVectors above = lanes(upper_, found, k), below = lanes(lower_, found, k);
      if (HWY_UNLIKELY(fixed_.any_near(above) || fixed_.any_near(below))) return false;
      upper_index = index(above);
      lower_index = index(below);
    }
    const Pixel* const window = texels_ + found.place[k];
    *upper = pick<kHalfColumnBits>(window, pitch_texel_, kHalfWindowRows, upper_index);
    *lower = pick<kHalfColumnBits>(window, pitch_texel_, kHalfWindowRows, lower_index);
    return true;
  }

 private:
  static HWY_INLINE Lane way_to_least(const AffineField& field) {
    const Lane down{HWY_MIN(field.step_y.u_fx32, 0), HWY_MIN(field.step_y.v_fx32, 0)};
    return plus(way_to_anchor(field.step_x), 1, down);
  }
  // From the least lane of both rows to those of one. The upper row (`sign` -1) lies above it where
  // the map falls from row to row, the lower one (1) where it rises.
  static HWY_INLINE LaneVectors offsets(const AffineField& field, int64_t sign) {
    const auto of = [&](int64_t step_x_fx32, int64_t step_y_fx32) HWY_ATTR {
      const int64_t from_fx32 = HWY_MAX(sign * step_y_fx32, 0);
      return offsets_from_anchor<kAnchorShift>(step_x_fx32, from_fx32);
    };
    return {of(field.step_x.u_fx32, field.step_y.u_fx32),
            of(field.step_x.v_fx32, field.step_y.v_fx32)};
  }
  static HWY_INLINE LaneVectors lanes(const LaneVectors& offsets, const FoundWindows& found,
                                      int32_t k) {
    const D32 d;
    return {hn::Add(hn::Set(d, found.u_fx16[k]), offsets.u),
            hn::Add(hn::Set(d, found.v_fx16[k]), offsets.v)};
  }
  static HWY_INLINE V32 index(const LaneVectors& lanes) {
    return Fixed::template window_index<kHalfColumnBits>(lanes, kHalfWindowRows);
  }

  using Fixed = FixedLanes<Addressed<InsideVector>>;

  Fixed fixed_;
  Lane to_anchor_;
  LaneVectors upper_, lower_;
  Coarse coarse_upper_, coarse_lower_;
  const Pixel* texels_;
  ptrdiff_t pitch_texel_;
};

// Pairs of rows from a place on, as far as there is room for what is left of them.
template <class Pixel>
HWY_NOINLINE void draw_pairs(const AffineSpans& spans, const Surface& surface, Resume* at,
                             Left* left) {
  const AffineField field = spans.field;
  const PairPicker<Pixel> by(spans, surface);
  const WindowFinder<typename PairPicker<Pixel>::Coarse> finder(
      surface, {kHalfColumnBits, kHalfWindowRows}, true);
  const AnchorRun run_u(field.step_x.u_fx32), run_v(field.step_x.v_fx32);
  const Lane to_anchor = by.to_anchor();
  FoundWindows found[2];
  PairRun runs[2];
  PairWalk walk(spans.batch, *at, FoundWindows::kMost);
  const auto find_next = [&](int32_t i) HWY_ATTR __attribute__((always_inline)) {
    if (!walk.next(&runs[i])) return false;
    const Lane anchor = plus(field.at(runs[i].px, runs[i].upper.row), 1, to_anchor);
    for (int32_t k = 0; k < runs[i].vectors; k += kLanes) {
      finder.find(run_u.from(anchor.u_fx32, k), run_v.from(anchor.v_fx32, k), k, &found[i]);
    }
    return true;
  };
  left->count = 0;
  int32_t i = 0;
  for (bool has_run = find_next(i); has_run; i ^= 1) {
    has_run = find_next(i ^ 1);
    const PairRun& run = runs[i];
    const int32_t drawn = draw_pair_run<Pixel>(by, found[i], run, surface, left);
    if (drawn < run.vectors) {
      *at = {run.index, run.px + drawn * kLanes};
      return;
    }
  }
  *at = walk.at();
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
