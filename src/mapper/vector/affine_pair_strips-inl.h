// Affine spans two rows at a time, a column of vectors after another. Included once for each SIMD
// target.
#if defined(SELVAGE_VECTOR_AFFINE_PAIR_STRIPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_PAIR_STRIPS_INL_H
#undef SELVAGE_VECTOR_AFFINE_PAIR_STRIPS_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_PAIR_STRIPS_INL_H
#endif

#include <array>
#include <bit>

#include "mapper/vector/affine_narrow-inl.h"
#include "mapper/vector/affine_window_pairs-inl.h"
#include "mapper/vector/affine_window_runs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Whether columns cost less than runs along rows: where a row crosses many of the texture, their
// lines leave the cache before the next two rows meet them; the sooner where a pitch has them share
// one set of it. Else runs along wide rows cost less, and so they do for a few rows.
[[nodiscard]] HWY_INLINE bool pays_pair_strips(const AffineSpans& spans,
                                               const selvage_texture& texture) {
  constexpr int64_t kSixteenth_fx32 = (int64_t{1} << kLaneFraction) / 16;
  constexpr ptrdiff_t kSets_bytes = 4096;
  const int64_t flat_fx32 = (texture.pitch % kSets_bytes == 0 ? 1 : 3) * kSixteenth_fx32;
  return spans.batch.rows >= kLeastWindowStripRows &&
         (spans.batch.widest_px <= kMostWindowStrips_px ||
          magnitude_fx32(spans.field.step_x.v_fx32) > flat_fx32);
}

// A column of vectors, one of each row of a batch, two rows at a time: pairs that have pixels in
// it, and of those the ones all of whose pixels are the rows'. As bits.
struct PairColumn {
  uint32_t with_pixels, whole;

  [[nodiscard]] HWY_INLINE bool empty() const { return with_pixels == 0; }
  [[nodiscard]] HWY_INLINE int32_t first() const { return std::countr_zero(with_pixels); }
  [[nodiscard]] HWY_INLINE int32_t end() const { return 32 - std::countl_zero(with_pixels); }
  // From a pair on, the first one that is not whole.
  [[nodiscard]] HWY_INLINE int32_t end_whole(int32_t pair) const {
    return pair + std::countr_one(whole >> pair);
  }
};

// Where the rows of a batch begin and end, those of a pair apart. A last row may have none below.
class PairEnds {
 public:
  HWY_INLINE explicit PairEnds(const SpanBatch& batch) {
    const D32 d;
    V32 left = hn::Set(d, INT32_MAX), right = hn::Set(d, INT32_MIN);
    for (int32_t row = 0, pair = 0; row < batch.rows; row += 2 * kLanes, pair += kLanes) {
      const auto ends = [&](const auto& px, int32_t from) HWY_ATTR {
        const auto is_row = hn::Lt(hn::Iota(d, from), hn::Set(d, batch.rows));
        return hn::IfThenElseZero(is_row, hn::LoadU(d, px.data() + from));
      };
      const auto put = [&](const auto& px, int32_t* upper, int32_t* lower) HWY_ATTR {
        const V32 first = ends(px, row), next = ends(px, row + kLanes);
        hn::StoreU(hn::ConcatEven(d, next, first), d, upper + pair);
        hn::StoreU(hn::ConcatOdd(d, next, first), d, lower + pair);
      };
      put(batch.left_px, upper_left_, lower_left_);
      put(batch.right_px, upper_right_, lower_right_);
      const auto spread = [&](const int32_t* from, const int32_t* to) HWY_ATTR {
        const V32 begin = hn::LoadU(d, from + pair), end = hn::LoadU(d, to + pair);
        const auto has = hn::Lt(begin, end);
        left = hn::Min(left, hn::IfThenElse(has, begin, left));
        right = hn::Max(right, hn::IfThenElse(has, end, right));
      };
      spread(upper_left_, upper_right_);
      spread(lower_left_, lower_right_);
    }
    left_px_ = hn::GetLane(hn::MinOfLanes(d, left));
    right_px_ = hn::GetLane(hn::MaxOfLanes(d, right));
  }

  [[nodiscard]] HWY_INLINE int32_t left_px() const { return left_px_; }
  [[nodiscard]] HWY_INLINE int32_t right_px() const { return right_px_; }
  // Those that begin at this pixel.
  [[nodiscard]] HWY_INLINE PairColumn column(int32_t px) const {
    const D32 d;
    const V32 begin = hn::Set(d, px), end = hn::Set(d, px + kLanes);
    PairColumn column{};
    for (int32_t pair = 0; pair < kMostPairs; pair += kLanes) {
      const auto bits = [&](auto mask)
                            HWY_ATTR { return static_cast<uint32_t>(bits_of(mask)) << pair; };
      const V32 upper_left = hn::LoadU(d, upper_left_ + pair);
      const V32 upper_right = hn::LoadU(d, upper_right_ + pair);
      const V32 lower_left = hn::LoadU(d, lower_left_ + pair);
      const V32 lower_right = hn::LoadU(d, lower_right_ + pair);
      const auto above = hn::And(hn::Lt(upper_left, end), hn::Gt(upper_right, begin));
      const auto below = hn::And(hn::Lt(lower_left, end), hn::Gt(lower_right, begin));
      const V32 last_left = hn::Max(upper_left, lower_left);
      const V32 first_right = hn::Min(upper_right, lower_right);
      column.with_pixels |= bits(hn::Or(above, below));
      column.whole |= bits(hn::Not(hn::Or(hn::Gt(last_left, begin), hn::Lt(first_right, end))));
    }
    return column;
  }
  [[nodiscard]] HWY_INLINE Span upper(int32_t pair, int32_t first_row) const {
    return {first_row + 2 * pair, upper_left_[pair], upper_right_[pair]};
  }
  [[nodiscard]] HWY_INLINE Span lower(int32_t pair, int32_t first_row) const {
    return {first_row + 2 * pair + 1, lower_left_[pair], lower_right_[pair]};
  }

 private:
  static constexpr int32_t kMostPairs = kRowsPerBatch / 2;
  static_assert(kMostPairs % kLanes == 0 && kMostPairs <= 32);

  HWY_ALIGN int32_t upper_left_[kMostPairs] = {}, upper_right_[kMostPairs] = {};
  HWY_ALIGN int32_t lower_left_[kMostPairs] = {}, lower_right_[kMostPairs] = {};
  int32_t left_px_, right_px_;
};

// Where the first pairs of a column are all left, so many of them, so are the others: they hardly
// would be drawn.
inline constexpr int32_t kFirstLeftPairs = 4;

// Draws the vectors that begin at a pixel, and puts those down that are left.
template <class Pixel, class Picker>
HWY_INLINE void draw_pair_column(const Picker& by, const FoundWindows& found, const PairEnds& ends,
                                 const PairColumn& column, int32_t px, const Surface& surface,
                                 int32_t first_row, Left* left) {
  const hn::Rebind<Pixel, D32> d;
  const int32_t first = column.first(), end = column.end();
  int32_t k = first, left_pairs = 0;
  // Modulo 2^64: beside the rows there may be no address.
  const auto pitch = static_cast<uintptr_t>(ptrdiff_t{surface.target.pitch});
  auto at = reinterpret_cast<uintptr_t>(first_pixel(surface, {first_row, 0, 0}));
  at += 2 * static_cast<uintptr_t>(k) * pitch;
  at += static_cast<uintptr_t>(px * ptrdiff_t{sizeof(Pixel)});
  const auto upper = [&] { return reinterpret_cast<Pixel*>(at); };
  const auto lower = [&] { return reinterpret_cast<Pixel*>(at + pitch); };
  left->count = 0;
  V32 above, below;
  for (; k < end; ++k, at += 2 * pitch) {
    const bool all_left = left_pairs >= kFirstLeftPairs && left_pairs == k - first;
    const int32_t end_whole = all_left ? k : column.end_whole(k);
    for (; k < end_whole; ++k, at += 2 * pitch) {
      if (HWY_UNLIKELY(!by.pick_both(found, k, &above, &below))) break;
      hn::StoreU(as_pixels<Pixel>(above), d, upper());
      hn::StoreU(as_pixels<Pixel>(below), d, lower());
    }
    if (k == end) break;
    const Span upper_row = ends.upper(k, first_row), lower_row = ends.lower(k, first_row);
    if (HWY_LIKELY(!all_left) && HWY_LIKELY(by.pick_both(found, k, &above, &below))) {
      store_within(above, upper_row, px, upper());
      store_within(below, lower_row, px, lower());
    } else {
      leave(upper_row, px, left);
      leave(lower_row, px, left);
      ++left_pairs;
    }
  }
}

// What is left of some columns, kept until they tell whether near-ties are many: of one alone all
// may be left where u does not change from row to row. Of few columns the first tells: others would
// cost too much of what is drawn once more.
class LeftColumns {
 public:
  HWY_INLINE LeftColumns(RestDraw* rest, int32_t columns)
      : rest_(rest), most_(static_cast<size_t>(HWY_MIN(HWY_MAX(columns / 4, 1), kMost))) {}

  // What is left of the next column.
  HWY_INLINE Left* next() { return &columns_[count_]; }
  // That was one of so many vectors. False where all rows have been drawn.
  HWY_INLINE bool keep(int32_t vectors) {
    vectors_ += vectors;
    const int32_t left = columns_[count_].count;
    if (left == 0) return true;
    left_ += left;
    return ++count_ < most_ || finish();
  }
  HWY_INLINE bool finish() {
    // Each with its share of the vectors: so all are many, or none. Rows above those of a column
    // may have pixels in others: none is drawn all the way before the last.
    for (size_t i = 0; i < count_; ++i) {
      const int64_t share = int64_t{vectors_} * columns_[i].count / left_;
      if (!rest_->draw(columns_[i], 0, static_cast<int32_t>(share))) return false;
    }
    count_ = 0;
    return true;
  }

 private:
  static constexpr int32_t kMost = 4;

  RestDraw* rest_;
  size_t most_;
  size_t count_ = 0;
  int32_t vectors_ = 0, left_ = 0;  // of all columns so far
  std::array<Left, kMost> columns_;
};

// Draws a batch a column of vectors after another, and what is left of them by rest->draw().
template <class Pixel, int kColumnBits, int32_t kRows>
HWY_NOINLINE void draw_pair_strips(const AffineSpans& spans, const Surface& surface,
                                   const WindowShape& shape, RestDraw* rest) {
  static_assert(Left::kMost >= kRowsPerBatch);
  const AffineField field = spans.field;
  const int32_t first_row = spans.batch.first_row;
  using Picker = PairPicker<Pixel, kColumnBits, kRows>;
  const Picker by(spans, surface);
  const WindowFinder<typename Picker::Coarse> finder(surface, shape, true);
  const AnchorRun run_u(2 * field.step_y.u_fx32), run_v(2 * field.step_y.v_fx32);
  const PairEnds ends(spans.batch);
  FoundWindows found;
  LeftColumns left(rest, (ends.right_px() - ends.left_px()) / kLanes);
  for (int32_t px = first_of_line<Pixel>(surface, {first_row, ends.left_px(), 0});
       px < ends.right_px(); px += kLanes) {
    const PairColumn column = ends.column(px);
    if (column.empty()) continue;
    const Lane anchor = plus(field.at(px, first_row), 1, by.to_anchor());
    for (int32_t k = column.first(); k < column.end(); k += kLanes) {
      finder.find(run_u.from(anchor.u_fx32, k), run_v.from(anchor.v_fx32, k), k, &found);
    }
    draw_pair_column<Pixel>(by, found, ends, column, px, surface, first_row, left.next());
    if (!left.keep(2 * (column.end() - column.first()))) return;
  }
  static_cast<void>(left.finish());
}

struct PairStrips {
  const AffineSpans& spans;
  const Surface& surface;
  RestDraw* rest;

  template <class Pixel, int kColumnBits, int32_t kRows>
  HWY_INLINE void draw(const WindowShape& shape) const {
    draw_pair_strips<Pixel, kColumnBits, kRows>(spans, surface, shape, rest);
  }
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
