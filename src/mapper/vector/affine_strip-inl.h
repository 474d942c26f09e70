// Strips of narrow affine spans, a vector of each row, what they need found some rows at once.
// Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_STRIP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_STRIP_INL_H
#undef SELVAGE_VECTOR_AFFINE_STRIP_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_STRIP_INL_H
#endif

#include <type_traits>

#include "mapper/vector/affine_lanes-inl.h"
#include "mapper/vector/left-inl.h"
#include "mapper/vector/one_window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

using Wide = hn::Repartition<int64_t, D32>;
using WideVector = hn::Vec<Wide>;

// px step, modulo 2^64, by 32 bits of the step at a time. Pixels are not negative, but for those
// behind a batch's last row, which are anything.
class PixelWalk {
 public:
  explicit HWY_INLINE PixelWalk(WideVector step_fx32)
      : step_(hn::BitCast(Unsigned(), step_fx32)), high_(hn::ShiftRight<32>(step_)) {}

  HWY_INLINE WideVector by(WideVector px) const {
    const hn::Repartition<uint32_t, D32> words;
    const auto times = [&](hn::Vec<Unsigned> digit) HWY_ATTR {
      return hn::MulEven(hn::BitCast(words, px), hn::BitCast(words, digit));
    };
    return hn::BitCast(Wide(), hn::Add(times(step_), hn::ShiftLeft<32>(times(high_))));
  }

 private:
  using Unsigned = hn::RebindToUnsigned<Wide>;

  hn::Vec<Unsigned> step_, high_;
};

// One coordinate of the anchors, modulo 2^64, of kLanes rows at a time, of vectors that begin at
// some pixels of them.
class WideAnchorLine {
 public:
  // `first_fx32`: that of the first row's vector that begins at pixel 0.
  HWY_INLINE WideAnchorLine(int64_t first_fx32, int64_t step_x_fx32, int64_t step_y_fx32)
      : walk_(hn::Set(Wide(), step_x_fx32)),
        down_(hn::ShiftLeft<kRowBits>(hn::Set(Wide(), step_y_fx32))),
        rows_(hn::Add(hn::Set(Wide(), first_fx32),
                      hn::Mul(hn::Iota(Wide(), 0), hn::Set(Wide(), step_y_fx32)))) {}

  // Pixels are not negative. Goes down to the rows below.
  HWY_INLINE WideLanes next(V32 px) {
    const hn::Half<D32> half;
    const auto low = hn::Add(rows_, walk_.by(hn::PromoteTo(Wide(), hn::LowerHalf(half, px))));
    rows_ = hn::Add(rows_, down_);
    const auto high = hn::Add(rows_, walk_.by(hn::PromoteTo(Wide(), hn::UpperHalf(half, px))));
    rows_ = hn::Add(rows_, down_);
    return {hn::BitCast(D32(), low), hn::BitCast(D32(), high)};
  }

 private:
  static constexpr int kRowBits = kLanes == 16 ? 3 : kLanes == 8 ? 2 : 1;
  static_assert(1 << kRowBits == kLanes / 2);

  PixelWalk walk_;
  WideVector down_, rows_;
};

// Of both coordinates.
struct WidePair {
  WideLanes u, v;
};

// Anchors of both coordinates, as wide as the lanes of the map. `anchor`: of the vector that begins
// in column 0 of the batch's first row.
class WideAnchors {
 public:
  struct Lines {
    HWY_INLINE WidePair next(V32 px) { return {u.next(px), v.next(px)}; }

    WideAnchorLine u, v;
  };

  HWY_INLINE WideAnchors(const AffineField& field, Lane anchor)
      : anchor_(anchor), step_x_(field.step_x), step_y_(field.step_y) {}

  // From a row of the batch on.
  HWY_INLINE Lines from(int32_t row) const {
    const Lane first = plus(anchor_, row, step_y_);
    return {WideAnchorLine(first.u_fx32, step_x_.u_fx32, step_y_.u_fx32),
            WideAnchorLine(first.v_fx32, step_x_.v_fx32, step_y_.v_fx32)};
  }

 private:
  Lane anchor_, step_x_, step_y_;
};

// A vector of each row of a batch: where it begins, and how many pixels there are from there on.
struct Strip {
  HWY_ALIGN int32_t from_px[kRowsPerBatch + kLanes], count_px[kRowsPerBatch + kLanes];

  HWY_INLINE void put(int32_t row, const StripEnds& ends) {
    hn::StoreU(ends.from_px, D32(), from_px + row);
    hn::StoreU(ends.count_px, D32(), count_px + row);
  }
};

// The same, with the anchors of the vectors.
struct AnchoredStrip : Strip {
  HWY_ALIGN int32_t u_fx16[kRowsPerBatch + kLanes], v_fx16[kRowsPerBatch + kLanes];

  HWY_INLINE void put(int32_t row, const StripEnds& ends, const WidePair& at) {
    Strip::put(row, ends);
    hn::StoreU(at.u.floors_fx16(), D32(), u_fx16 + row);
    hn::StoreU(at.v.floors_fx16(), D32(), v_fx16 + row);
  }
};

// Calls strip->put(row, ends, anchors) for kLanes rows at a time, maybe with some beyond the last
// one. Returns whether the vectors of all rows are whole.
template <class AnyStrip, class Anchors>
HWY_INLINE bool find_strip(const SpanBatch& batch, const RowBlock& rows, int32_t right_by_px,
                           const Anchors& anchors, AnyStrip* strip) {
  const D32 d;
  V32 least_px = hn::Set(d, kLanes);
  auto lines = anchors.from(rows.first);
  for (int32_t row = rows.first; row < rows.end; row += kLanes) {
    const StripEnds ends = strip_ends<kLanes>(batch, row, right_by_px);
    strip->put(row, ends, lines.next(ends.from_px));
    const auto is_row = hn::Lt(hn::Iota(d, row), hn::Set(d, rows.end));
    least_px = hn::Min(least_px, hn::IfThenElse(is_row, ends.count_px, least_px));
  }
  return hn::AllTrue(d, hn::Eq(least_px, hn::Set(d, kLanes)));
}

using WholeVector = std::integral_constant<int32_t, kLanes>;

template <bool kWhole>
[[nodiscard]] HWY_INLINE auto count_for(int32_t count_px) {
  if constexpr (kWhole) {
    return WholeVector();
  } else {
    return count_px;
  }
}

// Where the first vectors of a strip are all left, so many of them, the others are not drawn: they
// are many, for which RestDraw draws all rows, as it does wherever there is more than one.
// With fewer lanes than the most it was measured to cost meshes more.
inline constexpr bool kEndsEarly = kLanes == kMostLanes;
inline constexpr int32_t kFirstLeft = 8;
static_assert(are_many(kFirstLeft, kFirstLeft));

// Calls by->draw(strip, row, count_px, to) for the vectors of a strip, and puts those down for
// which it returns false. `kWhole`: all are whole, and count_px is a WholeVector. Returns the row
// behind the last one of which a vector was drawn or left.
template <class Pixel, bool kWhole, class AnyStrip, class By>
HWY_INLINE int32_t draw_strip(const AnyStrip& strip, const RowBlock& rows, const SpanBatch& batch,
                              const selvage_image& target, By* by, Left* left) {
  char* const pixels = static_cast<char*>(target.pixels);
  // Modulo 2^64: a pitch below the last row there may be no address.
  const auto pitch = static_cast<size_t>(target.pitch);
  size_t row = static_cast<size_t>(batch.first_row + rows.first) * pitch;
  int32_t left_count = 0, end = rows.end;
  for (int32_t i = rows.first; i < end; ++i) {
    const int32_t from_px = strip.from_px[i], count_px = strip.count_px[i];
    Pixel* const to = reinterpret_cast<Pixel*>(pixels + static_cast<ptrdiff_t>(row)) + from_px;
    if (HWY_UNLIKELY(!by->draw(strip, i, count_for<kWhole>(count_px), to)) && count_px > 0) {
      left->rest[static_cast<size_t>(left_count++)] = {batch.first_row + i, from_px,
                                                       from_px + count_px};
      if (kEndsEarly && left_count == kFirstLeft && i + 1 - rows.first == kFirstLeft) end = i + 1;
    }
    row += pitch;
  }
  left->count = left_count;
  return end;
}

// Draws a batch by strips, whole ones apart where By::kTellsWhole. Where some vectors of one are
// left, calls rest->draw(left, first_index, of_vectors) with the row of the batch above which all
// is drawn, and how many vectors the strip has. Ends where that returns false, or behind the first
// strip where by.is_in_vain(). Returns what it was drawn by, a copy, which stays in registers, for
// no store can change it.
template <class Pixel, class AnyStrip, class Anchors, class By, class Rest>
HWY_INLINE By draw_strips(By by, AnyStrip* strip, Anchors anchors, const SpanBatch& batch,
                          const Surface& surface, Rest* rest) {
  static_assert(Left::kMost >= kRowsPerBatch);
  Left left;
  const auto draw_block = [&](const RowBlock& block) HWY_ATTR __attribute__((always_inline)) {
    for (int32_t px = 0; px < block.widest_px; px += kLanes) {
      const RowBlock rows = px == 0 ? block : rows_with(batch, block, px);
      const bool is_whole = find_strip(batch, rows, px, anchors, strip);
      const int32_t end =
          By::kTellsWhole && is_whole
              ? draw_strip<Pixel, By::kTellsWhole>(*strip, rows, batch, surface.target, &by, &left)
              : draw_strip<Pixel, false>(*strip, rows, batch, surface.target, &by, &left);
      if (HWY_UNLIKELY(by.is_in_vain())) return false;
      if (HWY_UNLIKELY(left.count != 0) && !rest->draw(left, rows.first, end - rows.first)) {
        return false;
      }
    }
    return true;
  };
  for_each_block(batch, kLanes, rows_per_block(surface.target.pitch), draw_block);
  return by;
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
