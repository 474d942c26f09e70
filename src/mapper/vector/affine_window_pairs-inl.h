// Two rows of an affine map from one window: it holds the texels of a vector and of the one below
// it. Included once for each SIMD target.
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

// What a pixel costs by windows of single rows and of pairs, about, and a pair beside its pixels,
// as measured on AMD's family 25.
[[nodiscard]] constexpr int32_t cost_by_rows(const WindowShape& shape) {
  if (shape.rows == 0) return 36;
  return shape.is_half() ? 12 : HWY_MAX(15, 4 * shape.rows - 3);
}
[[nodiscard]] constexpr int32_t cost_by_pairs(const WindowShape& shape) {
  return shape.is_half() ? 8 : 2 * shape.rows + 3;
}
inline constexpr int32_t kPairCost = 600;
// More cost more than loads.
inline constexpr int32_t kMostPairRows = 7 * kRowsPerPermute;

[[nodiscard]] HWY_INLINE bool pays_pairs(const SpanBatch& batch, const WindowShape& of_rows,
                                         const WindowShape& of_pairs) {
  const int32_t row_cost = cost_by_rows(of_rows), pair_cost = cost_by_pairs(of_pairs);
  // Rows are as wide as the widest one at most.
  if (int64_t{2 * batch.widest_px} * (row_cost - pair_cost) < kPairCost) return false;
  int32_t by_rows_px = 0, by_pairs_px = 0;
  for (int32_t i = 0; i + 1 < batch.rows; i += 2) {
    const Span upper = batch.span(i), lower = batch.span(i + 1);
    by_rows_px += upper.width_px() + lower.width_px();
    by_pairs_px += 2 * around(upper, lower).width_px();
  }
  return int64_t{by_pairs_px} * pair_cost + batch.rows / 2 * kPairCost <=
         int64_t{by_rows_px} * row_cost;
}

// Windows that hold all texels of two vectors, one below the other; no rows where none does, or
// where those of one cost less.
[[nodiscard]] HWY_INLINE WindowShape pair_shape(const AffineSpans& spans,
                                                const selvage_texture& texture,
                                                const WindowShape& of_rows) {
  if (!kHasPairs || spans.batch.rows < 2) return {};
  const AffineField& field = spans.field;
  const auto texels = [&](int64_t Lane::*axis) {
    return texels_across(reach_fx32(kLanes - 1, field.step_x.*axis) +
                         reach_fx32(1, field.step_y.*axis));
  };
  const WindowShape shape =
      shape_that_holds<kMostPairRows>(texels(&Lane::u_fx32), texels(&Lane::v_fx32), texture);
  const bool pays = shape.rows != 0 && pays_pairs(spans.batch, of_rows, shape);
  return pays ? shape : WindowShape{};
}

// Calls by.template draw<Pixel, kColumnBits, kRows>(shape) as windows of this shape are drawn from.
template <class Pixel, int32_t kRows = kMostPairRows, class By>
HWY_INLINE void with_pair_shape(const WindowShape& shape, const By& by) {
  if constexpr (kRows == kMostPairRows) {
    if (shape.is_half()) return by.template draw<Pixel, kHalfColumnBits, kHalfWindowRows>(shape);
  }
  if constexpr (kRows > kRowsPerPermute) {
    if (shape.rows < kRows) return with_pair_shape<Pixel, kRows - kRowsPerPermute>(shape, by);
  }
  by.template draw<Pixel, kWindowColumnBits, kRows>(shape);
}

// Picks the texels of a vector and of the one below it, which the texture holds, from windows of
// one shape.
template <class Pixel, int kColumnBits, int32_t kRows>
class PairPicker {
 public:
  using Coarse = CoarseLanes<kColumnBits, kRows>;

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
    const V32 indices[] = {upper_index, lower_index};
    V32 picked[2];
    pick_all<kColumnBits>(texels_ + found.place[k], pitch_texel_, kRows, indices, picked);
    *upper = picked[0];
    *lower = picked[1];
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
    return Fixed::template window_index<kColumnBits>(lanes, kRows);
  }

  using Fixed = FixedLanes<Addressed<InsideVector>>;

  Fixed fixed_;
  Lane to_anchor_;
  LaneVectors upper_, lower_;
  Coarse coarse_upper_, coarse_lower_;
  const Pixel* texels_;
  ptrdiff_t pitch_texel_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
