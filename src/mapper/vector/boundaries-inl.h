// Spans of a polygon that shows few texels, with many near-ties among them: by the side of each
// boundary between the texels that pixels lie on, and by nothing else. Included once for each SIMD
// target.
#if defined(SELVAGE_VECTOR_BOUNDARIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BOUNDARIES_INL_H
#undef SELVAGE_VECTOR_BOUNDARIES_INL_H
#else
#define SELVAGE_VECTOR_BOUNDARIES_INL_H
#endif

#include <array>
#include <bit>

#include "mapper/exact_slab.h"
#include "mapper/near_tie_bits.h"
#include "mapper/to_double.h"
#include "mapper/vector/fetch-inl.h"
#include "mapper/vector/limbs-inl.h"
#include "mapper/vector/one_window-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// With more of them a row costs as much as what decides its near-ties would.
inline constexpr int32_t kMostBoundaries = 6;
inline constexpr int32_t kMostInPlane = 2;  // that needs more than one limb

// The texels of some columns and rows, a row after another, for permutes: two vectors of them.
class TexelTable {
 public:
  static constexpr int32_t kMost = 2 * kLanes;
  static_assert(!kHasWindows || (kMostBoundaries / 2 + 1) * (kMostBoundaries / 2 + 1) <= kMost,
                "as many columns as rows");

  template <class Pixel, class Address>
  static HWY_NOINLINE TexelTable of(const TexelRanges& texels, const selvage_texture& texture) {
    const D32 d;
    const Extent extent = extent_of(texture);
    HWY_ALIGN int32_t s[kMost]{}, t[kMost]{}, texel[kMost]{};
    int32_t end = 0;
    for (int32_t row = texels.t.first; row <= texels.t.last; ++row) {
      for (int32_t column = texels.s.first; column <= texels.s.last; ++column, ++end) {
        s[end] = column;
        t[end] = row;
      }
    }
    for (int32_t i = 0; i < end; i += kLanes) {
      hn::Store(Address::place(hn::Load(d, s + i), hn::Load(d, t + i), extent), d, t + i);
    }
    for (int32_t i = 0; i < end; ++i) {
      texel[i] = static_cast<int32_t>(texel_at<Pixel>(texture.texels, t[i]));
    }
    return {hn::Load(d, texel), hn::Load(d, texel + kLanes)};
  }

  [[nodiscard]] HWY_INLINE V32 pick(V32 index) const {
#if HWY_TARGET == HWY_AVX3
    return V32{_mm512_permutex2var_epi32(low_.raw, index.raw, high_.raw)};
#elif HWY_TARGET == HWY_AVX2
    const V32 low{_mm256_permutevar8x32_epi32(low_.raw, index.raw)};
    const V32 high{_mm256_permutevar8x32_epi32(high_.raw, index.raw)};
    return hn::IfThenElse(hn::Gt(index, hn::Set(D32(), kLanes - 1)), high, low);
#else
    return index;  // there are no windows
#endif
  }

 private:
  HWY_INLINE TexelTable(V32 low, V32 high) : low_(low), high_(high) {}
  V32 low_, high_;
};

// The exact lines of a batch's rows from one on, as far as they serve.
struct ExactLines {
  SlabLine<uint128> u, v, d;
  int32_t column_px, end_row;
  double most_denominator;  // no less than d at all pixels
};

// most_ruled: no less than any denominator, where some rows each have a map of their own.
[[nodiscard]] inline ExactLines lines_from(const ExactMap& map, const SpanBatch& batch,
                                           int32_t index, double most_ruled) {
  const Span first = batch.span(index);
  if (!map.is_ruled() || batch.rows == 1) {
    const auto [row, below] = map.rows_from(first.left_px, first.row);
    const int128 most_d = most_in_box(row.d, below.d.start - row.d.start, batch);
    return {{row.u, below.u}, {row.v, below.v}, {row.d, below.d},
            first.left_px,    INT32_MAX,        to_double(most_d)};
  }
  const Slab slab = *from_left_to_right(map.ruled().slab_of(first.row));  // d > 0 at pixels
  const ExactSlab rows({slab.a, slab.b, first.row, slab.end_row}, first.left_px);
  return {rows.u(), rows.v(), rows.d(), first.left_px, slab.end_row, most_ruled};
}

// Where n / d is a whole number k: n - k d, which is negative before it. Begins with some row.
template <class Number>
class BoundaryLine {
 public:
  // By the lines of both.
  HWY_INLINE void set(const SlabLine<uint128>& n, const SlabLine<uint128>& d, int32_t k) {
    SlabLine<uint128> off = n;
    off.subtract(static_cast<uint128>(int128{k}), d);
    start_ = Walk::scalar(off.start);
    down_ = Walk::scalar(off.down);
    bend_ = Walk::scalar(off.bend);
    step_ = Walk::scalar(off.step);
    turn_ = Walk::scalar(off.turn);
    walk_.set_step(step_);
    bends_ = off.bend != 0 || off.turn != 0;
    if (bends_) turns_.set_step(turn_);
  }
  HWY_INLINE void go_down() {
    start_ = start_ + down_;
    if (!bends_) return;
    down_ = down_ + bend_;
    step_ = Walk::sum(step_, turn_);
    walk_.add_step(turns_);
  }
  // Negative where a vector's pixels are before the boundary.
  [[nodiscard]] HWY_INLINE V32 signs(int32_t right_px) const {
    return Number::signs(walk_.from(start_ + times(right_px, step_)));
  }

 private:
  using Walk = typename Number::Walk;
  using Scalar = typename Walk::Scalar;
  // Factors of a sum: of `down` the rows, of `bend` the pairs of rows, of `step` the pixels, and of
  // `turn` the rows times a vector's pixels.
  static constexpr int32_t kMostRows = kRowsPerBatch, kMost_px = 1 << 15;
  static_assert(1 + kMostRows + kMostRows * kMostRows / 2 + kMost_px + (kMostRows + 1) * kLanes <
                1 << LooseLimbs::kFactorBits);

  Scalar start_, down_, bend_, step_, turn_;  // as SlabLine has them
  Walk walk_, turns_;
  bool bends_;
};

// All of a table's: which texel of it a pixel shows.
template <class Number>
class BoundaryLines {
 public:
  HWY_INLINE BoundaryLines(const ExactLines& lines, const TexelRanges& texels)
      : column_px_(lines.column_px), columns_(texels.s.count()) {
    for (int32_t k = texels.s.first + 1; k <= texels.s.last; ++k) add(lines.u, lines.d, k);
    s_count_ = count_;
    for (int32_t k = texels.t.first + 1; k <= texels.t.last; ++k) add(lines.v, lines.d, k);
  }
  HWY_INLINE void go_down() {
    for (int32_t i = 0; i < count_; ++i) at(i).go_down();
  }
  // Of a vector of pixels.
  [[nodiscard]] HWY_INLINE V32 indices(int32_t px) const {
    const int32_t right_px = px - column_px_;
    return hn::Add(beyond(0, s_count_, right_px),
                   hn::Mul(beyond(s_count_, count_, right_px), hn::Set(D32(), columns_)));
  }

 private:
  HWY_INLINE void add(const SlabLine<uint128>& n, const SlabLine<uint128>& d, int32_t k) {
    at(count_++).set(n, d, k);
  }
  // How many of some boundaries pixels are at or beyond.
  [[nodiscard]] HWY_INLINE V32 beyond(int32_t first, int32_t end, int32_t right_px) const {
    const D32 d;
    V32 count = hn::Set(d, end - first);
    for (int32_t i = first; i < end; ++i) {
      count = hn::Add(count, hn::ShiftRight<31>(at(i).signs(right_px)));
    }
    return count;
  }
  [[nodiscard]] HWY_INLINE BoundaryLine<Number>& at(int32_t i) {
    return lines_[static_cast<size_t>(i)];
  }
  [[nodiscard]] HWY_INLINE const BoundaryLine<Number>& at(int32_t i) const {
    return lines_[static_cast<size_t>(i)];
  }

  int32_t column_px_, columns_, s_count_, count_ = 0;
  std::array<BoundaryLine<Number>, kMostBoundaries> lines_;
};

// The rows from an index in the batch on, as far as the lines serve. Returns the first one behind.
template <class Pixel, class Number>
HWY_NOINLINE int32_t draw_rows(const SpanBatch& batch, int32_t first_index, const ExactLines& exact,
                               const TexelRanges& texels, const TexelTable& table,
                               const Surface& surface) {
  BoundaryLines<Number> lines(exact, texels);
  int32_t i = first_index;
  for (; i < batch.rows; ++i) {
    const Span span = batch.span(i);
    if (span.row >= exact.end_row) break;
    if (!span.empty()) {
      auto* const to = reinterpret_cast<Pixel*>(first_pixel(surface, span));
      for_each_vector_of(span, [&](int32_t px, int32_t count_px) HWY_ATTR {
        store_pixels(table.pick(lines.indices(span.left_px + px)), count_px, to + px);
      });
    }
    lines.go_down();
  }
  return i;
}

// |n - k d| of texels in a table is no more than 2^kOffBits d.
inline constexpr int kOffBits = std::bit_width(static_cast<uint32_t>(kMostBoundaries));

// All pixels show some of these texels. False where it does not pay, or numbers are too great.
// most_ruled is that of lines_from().
template <class Pixel, class Address>
[[nodiscard]] HWY_NOINLINE bool draw_between_boundaries(const SpanBatch& batch,
                                                        const TexelRanges& texels,
                                                        const ExactMap& map, double most_ruled,
                                                        const Surface& surface) {
  const int32_t boundaries = texels.s.count() + texels.t.count() - 2;
  if (!kHasWindows || boundaries > kMostBoundaries) return false;
  const bool is_ruled = map.is_ruled() && batch.rows > 1;
  if (is_ruled && !is_directed(map.ruled())) return false;
  ExactLines lines = lines_from(map, batch, 0, most_ruled);
  const bool in_one_limb = are_enough(OneLimb::kBits, lines.most_denominator, -kOffBits);
  const bool in_two_limbs = (is_ruled || boundaries <= kMostInPlane) &&
                            are_enough(LooseLimbs::kBits, lines.most_denominator, -kOffBits);
  if (!in_one_limb && !in_two_limbs) return false;
  const TexelTable table = TexelTable::of<Pixel, Address>(texels, surface.texture);
  for (int32_t i = 0;;) {
    i = in_one_limb ? draw_rows<Pixel, OneLimb>(batch, i, lines, texels, table, surface)
                    : draw_rows<Pixel, LooseLimbs>(batch, i, lines, texels, table, surface);
    if (i == batch.rows) return true;
    lines = lines_from(map, batch, i, most_ruled);
  }
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
