// Small polygons by lists of their pixels, for targets that cannot store a part of a vector.
// Included once for each SIMD target.
//
// Rows are a few pixels wide, and how many no processor foresees. One behind the other in a list
// they fill vectors, and no branch asks where they end. Lists of several polygons are written
// before the first is read: what was stored in pieces and is loaded as a vector waits for the
// stores.
#if defined(SELVAGE_VECTOR_SMALL_LIST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_SMALL_LIST_INL_H
#undef SELVAGE_VECTOR_SMALL_LIST_INL_H
#else
#define SELVAGE_VECTOR_SMALL_LIST_INL_H
#endif

#include <cstring>
#include <optional>

#include "mapper/vector/affine_window-inl.h"
#include "mapper/vector/small_set_up-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

#if SELVAGE_DRAWS_SMALL && HWY_TARGET != HWY_AVX3

// The pixels of some rows of a polygon.
class SmallList {
 public:
  // Between two columns, in rows [first_row, end_row) below the part's first.
  template <class Lines>
  HWY_INLINE void find(const Lines& lines, int32_t first_px, int32_t end_px, int32_t first_row,
                       int32_t end_row) {
    const CodeTag d;
    const Rows rows(lines, first_px, end_px, first_row, end_row);
    int32_t count = 0;
    for (int32_t k = 0; k < end_row - first_row; ++k) {
      const auto left = hn::Set(d, static_cast<uint16_t>(rows.left_code[k]));
      hn::StoreU(hn::Add(left, hn::Iota(d, 0)), d, code_ + count);
      count += rows.count_px[k];
    }
    if (count != 0) hn::StoreU(hn::Set(d, code_[count - 1]), d, code_ + count);
    count_ = count;
  }

  [[nodiscard]] HWY_INLINE int32_t count() const { return count_; }
  // Of a vector of them, from a multiple of kLanes on. Behind the last one it is repeated.
  [[nodiscard]] HWY_INLINE PixelSteps steps(int32_t from) const {
    const D32 d;
    const V32 code = hn::PromoteTo(d, hn::Load(hn::Rebind<uint16_t, D32>(), code_ + from));
    return {hn::And(code, hn::Set(d, kRightMask)), hn::ShiftRight<kRightBits>(code)};
  }

 private:
  // Steps are a byte each, those to the right in the low one.
  static constexpr int kRightBits = 8;
  static constexpr int32_t kRightMask = (1 << kRightBits) - 1;
  static constexpr int32_t kMostRow_px = kSmall.most_px, kMost_px = kMostRow_px * kMostRow_px;
  using CodeTag = hn::FixedTag<uint16_t, kMostRow_px>;
  static_assert(2 * kMostRow_px <= kRightMask && kLanes <= kMostRow_px);

  // Of each row: its first pixel, and how many there are.
  struct Rows {
    HWY_ALIGN int32_t left_code[kMostRow_px], count_px[kMostRow_px];

    template <class Lines>
    HWY_INLINE Rows(const Lines& lines, int32_t first_px, int32_t end_px, int32_t first_row,
                    int32_t end_row) {
      const D32 d;
      for (int32_t k = 0; k < end_row - first_row; k += kLanes) {
        const SmallSpans spans(lines, first_row + k, first_px, end_px);
        const V32 down = hn::ShiftLeft<kRightBits>(hn::Iota(d, first_row + k));
        const V32 right = hn::Sub(spans.left_px, hn::Set(d, first_px));
        hn::Store(hn::Add(right, down), d, left_code + k);
        hn::Store(hn::Sub(spans.right_px, spans.left_px), d, count_px + k);
      }
    }
  };

  int32_t count_;
  HWY_ALIGN uint16_t code_[kMost_px + kMostRow_px];
};

// Exact texels, out of the loop. What they are found by is set up for a polygon's first ones.
template <class Kind>
class SmallExactTexels {
 public:
  [[nodiscard]] HWY_NOINLINE TexelVectors at(const SmallSetUp<Kind>& set_up, size_t i,
                                             const PixelSteps& steps,
                                             const selvage_texture& texture) {
    if (!exact_ || i != of_) exact_.emplace(set_up.exact(i, texture));
    of_ = i;
    const LaneVectors exact_fx16 = exact_->at(steps, kLanes);
    return {hn::ShiftRight<kTexelFraction>(exact_fx16.u),
            hn::ShiftRight<kTexelFraction>(exact_fx16.v)};
  }

 private:
  size_t of_ = 0;
  std::optional<typename Kind::Exact> exact_;
};

// Where pixels are copied from and to: numbers that go through memory, for taking vectors apart
// costs more.
class SmallCopies {
 public:
  HWY_INLINE SmallCopies(V32 from_texel, V32 to_byte) {
    hn::Store(from_texel, D32(), from_texel_);
    hn::Store(to_byte, D32(), to_byte_);
  }
  template <class Pixel>
  HWY_INLINE void copy(const Pixel* from, char* to) const {
#pragma GCC unroll 16
    for (int32_t i = 0; i < kLanes; ++i) {
      std::memcpy(to + loaded(to_byte_ + i), from + loaded(from_texel_ + i), sizeof(Pixel));
    }
  }

 private:
  static HWY_INLINE ptrdiff_t loaded(const int32_t* number) {
    return *static_cast<const volatile int32_t*>(number);
  }

  HWY_ALIGN int32_t from_texel_[kLanes], to_byte_[kLanes];
};

// Copies the texels of the i-th polygon that was set up. `first_pixel` is the part's first one, or
// the one so many rows below it.
template <class Pixel, class Kind>
HWY_INLINE void draw_list(const SmallList& list, const SmallSetUp<Kind>& set_up, size_t i,
                          const Surface& surface, char* first_pixel, int32_t first_row,
                          SmallExactTexels<Kind>* exact) {
  const D32 d;
  const selvage_texture& texture = surface.texture;
  const auto pitch_texel = static_cast<int32_t>(pitch_texel_of(texture));
  const V32 row_texel = hn::Set(d, pitch_texel),
            first_texel = hn::Set(d, set_up.t_texel[i] * pitch_texel + set_up.s_texel[i]),
            row_byte = hn::Set(d, static_cast<int32_t>(surface.target.pitch)),
            pixel_byte = hn::Set(d, int32_t{sizeof(Pixel)});
  const typename Kind::Lanes all_lanes(set_up.maps, i);
  const LowFineLanes low(set_up.maps.lack_fx24(i));
  const bool has_lanes = set_up.maps.has_lanes(i);
  const auto* const texels_of = static_cast<const Pixel*>(texture.texels);
  const int32_t count = list.count();
  for (int32_t k = 0; k < count; k += kLanes) {
    const PixelSteps steps = list.steps(k);
    const LaneVectors lanes = all_lanes.at(steps);
    TexelVectors texels{hn::ShiftRight<kWindowFraction>(lanes.u),
                        hn::ShiftRight<kWindowFraction>(lanes.v)};
    if (HWY_UNLIKELY(!has_lanes || changes_texels<kWindowFraction>(low.changes(lanes)))) {
      texels = exact->at(set_up, i, steps, texture);
    }
    const V32 from_texel = hn::Add(hn::Mul(texels.t, row_texel), hn::Add(texels.s, first_texel));
    const V32 down_px = hn::Sub(steps.down_px, hn::Set(d, first_row));
    const SmallCopies copies(
        from_texel, hn::Add(hn::Mul(down_px, row_byte), hn::Mul(steps.right_px, pixel_byte)));
    copies.copy(texels_of, first_pixel);
  }
}

// Whether the rows of a polygon are so near that 32 bits hold how far.
[[nodiscard]] HWY_INLINE bool are_rows_near(const selvage_image& target) {
  constexpr ptrdiff_t kMost = INT32_MAX / (kSmall.most_px + 1);
  return target.pitch >= -kMost && target.pitch <= kMost;
}

// Of those that were set up, the lists of the polygons from an index on.
template <class Pixel, class Kind>
class SmallSet {
 public:
  HWY_INLINE SmallSet(const SmallPolygons& polygons, const SmallSetUp<Kind>& set_up, size_t first,
                      const Surface& surface)
      : polygons_(polygons), set_up_(set_up), first_(first), surface_(surface) {}

  [[nodiscard]] HWY_INLINE int32_t rows(size_t index) const {
    return polygons_.end_row()[index] - polygons_.first_row()[index];
  }
  HWY_INLINE void find(size_t index, int32_t first_row, int32_t end_row, SmallList* list) const {
    list->find(set_up_.edges.of(index - first_), polygons_.left_px()[index],
               polygons_.right_px()[index], first_row, end_row);
  }
  HWY_INLINE void draw(size_t index, int32_t first_row, const SmallList& list,
                       SmallExactTexels<Kind>* exact) const {
    const Span row{polygons_.first_row()[index] + first_row, polygons_.left_px()[index], 0};
    draw_list<Pixel>(list, set_up_, index - first_, surface_, first_pixel(surface_, row), first_row,
                     exact);
  }

 private:
  const SmallPolygons& polygons_;
  const SmallSetUp<Kind>& set_up_;
  size_t first_;
  const Surface& surface_;
};

// Row by row.
template <class Pixel, class Kind>
HWY_NOINLINE void draw_far_rows(const SmallSet<Pixel, Kind>& set, size_t first, size_t end) {
  SmallList list;
  SmallExactTexels<Kind> exact;
  for (size_t index = first; index < end; ++index) {
    for (int32_t row = 0; row < set.rows(index); ++row) {
      set.find(index, row, row + 1, &list);
      set.draw(index, row, list, &exact);
    }
  }
}

template <class Pixel, class Kind>
HWY_INLINE void draw_small_set(const SmallPolygons& polygons, const SmallSetUp<Kind>& set_up,
                               size_t first, size_t end, const Surface& surface) {
  const SmallSet<Pixel, Kind> set(polygons, set_up, first, surface);
  if (HWY_UNLIKELY(!are_rows_near(surface.target))) return draw_far_rows(set, first, end);
  SmallList lists[kRows];
  SmallExactTexels<Kind> exact;
  for (size_t index = first; index < end; ++index) {
    set.find(index, 0, set.rows(index), &lists[index - first]);
  }
  for (size_t index = first; index < end; ++index) set.draw(index, 0, lists[index - first], &exact);
}

#endif

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
