// Where small polygons' texels lie, several polygons at once: a lane is a polygon. Included once
// for each SIMD target.
#if defined(SELVAGE_VECTOR_SMALL_SHAPES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_SMALL_SHAPES_INL_H
#undef SELVAGE_VECTOR_SMALL_SHAPES_INL_H
#else
#define SELVAGE_VECTOR_SMALL_SHAPES_INL_H
#endif

#include <array>
#include <cstddef>

#include "mapper/vector/kernel.h"
#include "mapper/vector/small_edges-inl.h"
#include "mapper/vector/window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

#if SELVAGE_DRAWS_SMALL

// The windows that AVX-512 draws polygons from, the smaller ones first: what lies in none is
// loaded texel by texel. In meshes, where nobody foresees how many pixels a row has, that was
// measured to cost more than the largest of them. AVX2 has none: all its texels are loaded.
struct SmallShape {
  int column_bits;
  int32_t vectors;

  [[nodiscard]] constexpr int32_t columns() const { return 1 << column_bits; }
  [[nodiscard]] constexpr int32_t rows() const { return vectors * (kLanes >> column_bits); }
};
#if HWY_TARGET == HWY_AVX3
inline constexpr std::array<SmallShape, 4> kSmallShapes = {
    {{kHalfColumnBits, 2}, {kHalfColumnBits, 4}, {kWindowColumnBits, 8}, {kWindowColumnBits, 12}}};
#else
inline constexpr std::array<SmallShape, 0> kSmallShapes = {};
#endif
inline constexpr int32_t kSmallShapeCount = kSmallShapes.size();

// Where a window begins, u or v, and kLowered_fx24 where lanes are lowered by that.
inline constexpr int32_t kLowered_fx24 = 1;
struct SmallOrigin {
  Columns texel, lowered_fx24;
};

// Which of them, and where they begin: at the least texels, or before them, so that they lie in the
// texture.
struct SmallWindows {
  SmallOrigin s, t;
  Columns shape;

  HWY_INLINE SmallWindows(const SmallTexelRanges& ranges, const selvage_texture& texture) {
    const ColumnTag d;
    const TexelsOf u(ranges.u, texture.width), v(ranges.v, texture.height);
    s = {u.first, u.lowered_fx24};
    t = {v.first, v.lowered_fx24};
    shape = hn::Set(d, kSmallShapeCount);
    for (int32_t i = kSmallShapeCount - 1; i >= 0; --i) {
      const SmallShape window = kSmallShapes[static_cast<size_t>(i)];
      if (texture.width < window.columns() || texture.height < window.rows()) continue;
      const Columns column = hn::Min(u.first, hn::Set(d, texture.width - window.columns()));
      const Columns row = hn::Min(v.first, hn::Set(d, texture.height - window.rows()));
      const auto holds = hn::And(hn::Lt(hn::Sub(u.last, column), hn::Set(d, window.columns())),
                                 hn::Lt(hn::Sub(v.last, row), hn::Set(d, window.rows())));
      s.texel = hn::IfThenElse(holds, column, s.texel);
      t.texel = hn::IfThenElse(holds, row, t.texel);
      shape = hn::IfThenElse(holds, hn::Set(d, i), shape);
    }
  }

 private:
  // Of polygons, the first and the last one that they show.
  struct TexelsOf {
    Columns first, last, lowered_fx24;

    HWY_INLINE TexelsOf(const SmallRange& range_fx16, int32_t size_texel) {
      const ColumnTag d;
      const Columns end = hn::Set(d, size_texel);
      const Columns most = hn::ShiftRight<kTexelFraction>(range_fx16.most);
      const auto is_end = hn::Eq(most, end);
      lowered_fx24 = hn::IfThenElseZero(is_end, hn::Set(d, kLowered_fx24));
      last = hn::Min(most, hn::Sub(end, hn::Set(d, 1)));
      // All of them may be the end.
      first = hn::Min(hn::ShiftRight<kTexelFraction>(range_fx16.least), last);
    }
  };
};

// Where a polygon's texels are counted from, and how far from there the texture ends.
struct SmallTexels {
  int32_t first_s, first_t, end_s, end_t;
};

#endif

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
