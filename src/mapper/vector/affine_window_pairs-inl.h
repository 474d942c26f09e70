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

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Ends of rows, where fewer pixels are, are drawn by masks.
inline constexpr bool kHasPairs = kHasWindows && kHasMask;

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

// From the leftmost pixel of two rows to the rightmost one.
[[nodiscard]] HWY_INLINE Span around(const Span& upper, const Span& lower) {
  if (upper.empty()) return lower;
  if (lower.empty()) return upper;
  return {upper.row, HWY_MIN(upper.left_px, lower.left_px),
          HWY_MAX(upper.right_px, lower.right_px)};
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

// Vectors side by side of two rows, found at once.
struct PairRun {
  static constexpr int32_t kMost = FoundWindows::kMost;

  int32_t index;  // of the upper row in the batch
  Span upper, lower;
  int32_t px, vectors;

  // Those from here on are whole in both rows, up to there.
  [[nodiscard]] HWY_INLINE int32_t first_whole() const {
    const int32_t from_px = HWY_MAX(upper.left_px, lower.left_px) - px;
    return HWY_MIN(HWY_MAX(from_px + kLanes - 1, 0) / kLanes, vectors);
  }
  [[nodiscard]] HWY_INLINE int32_t end_whole() const {
    const int32_t to_px = HWY_MIN(upper.right_px, lower.right_px) - px;
    return HWY_MIN(HWY_MAX(to_px, 0) / kLanes, vectors);
  }
};

// All runs of a batch, but for a last row that has none below it.
class PairWalk {
 public:
  HWY_INLINE PairWalk(const SpanBatch& batch, const Resume& at) : batch_(batch), at_(at) {}

  // False where there is none left.
  HWY_INLINE bool next(PairRun* run) {
    for (; at_.row + 1 < batch_.rows; at_ = {at_.row + 2, INT32_MIN}) {
      const Span upper = batch_.span(at_.row), lower = batch_.span(at_.row + 1);
      const Span both = around(upper, lower);
      const int32_t from_px = HWY_MAX(at_.px, both.left_px);
      const int32_t rest_px = both.right_px - from_px;
      if (rest_px <= 0) continue;
      const int32_t vectors = HWY_MIN((rest_px + kLanes - 1) / kLanes, PairRun::kMost);
      *run = {at_.row, upper, lower, from_px, vectors};
      at_.px = from_px + vectors * kLanes;
      return true;
    }
    return false;
  }
  // Where it goes on.
  [[nodiscard]] HWY_INLINE const Resume& at() const { return at_; }

 private:
  const SpanBatch& batch_;
  Resume at_;
};

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

// Those pixels of a vector that begins at `px` that are the span's.
template <class Pixel>
HWY_INLINE void store_within(V32 texels, const Span& span, int32_t px, Pixel* row) {
  const hn::Rebind<Pixel, D32> d;
  const auto before = [&](int32_t end_px) HWY_ATTR {
    return hn::FirstN(d, static_cast<size_t>(HWY_MIN(HWY_MAX(end_px - px, 0), kLanes)));
  };
  hn::BlendedStore(as_pixels<Pixel>(texels),
                   hn::AndNot(before(span.left_px), before(span.right_px)), d, row + px);
}

// The same of what is left of a vector.
HWY_INLINE void leave(const Span& span, int32_t px, Left* left) {
  const Span rest{span.row, HWY_MAX(px, span.left_px), span.right_px};
  if (rest.empty() || rest.left_px >= px + kLanes) return;
  left->rest[static_cast<size_t>(left->count++)] = rest;
}

// Draws a run's vectors up to where there is no room for more that are left. Returns how many.
template <class Pixel>
HWY_INLINE int32_t draw_pair_run(const PairPicker<Pixel>& by, const FoundWindows& found,
                                 const PairRun& run, const Surface& surface, Left* left) {
  const auto row_of = [&](const Span& span) HWY_ATTR {
    return reinterpret_cast<Pixel*>(first_pixel(surface, {span.row, 0, 0}));
  };
  const hn::Rebind<Pixel, D32> d;
  Pixel *const upper = row_of(run.upper), *const lower = row_of(run.lower);
  const int32_t first_whole = run.first_whole(), end_whole = run.end_whole();
  int32_t px = run.px;
  V32 above, below;
  for (int32_t k = 0; k < run.vectors; ++k, px += kLanes) {
    for (; first_whole <= k && k < end_whole; ++k, px += kLanes) {
      if (HWY_UNLIKELY(!by.pick_both(found, k, &above, &below))) break;
      hn::StoreU(as_pixels<Pixel>(above), d, upper + px);
      hn::StoreU(as_pixels<Pixel>(below), d, lower + px);
    }
    if (k == run.vectors) break;
    if (HWY_LIKELY(by.pick_both(found, k, &above, &below))) {
      store_within(above, run.upper, px, upper);
      store_within(below, run.lower, px, lower);
      continue;
    }
    if (left->count > Left::kMost - 2) return k;
    leave(run.upper, px, left);
    leave(run.lower, px, left);
  }
  return run.vectors;
}

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
  PairWalk walk(spans.batch, *at);
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
    const int32_t drawn = draw_pair_run(by, found[i], run, surface, left);
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
