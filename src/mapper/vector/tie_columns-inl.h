// Near-ties column by column: a lane is a row, so that rows share what they would cost one by one.
// Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_TIE_COLUMNS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_TIE_COLUMNS_INL_H
#undef SELVAGE_VECTOR_TIE_COLUMNS_INL_H
#else
#define SELVAGE_VECTOR_TIE_COLUMNS_INL_H
#endif

#include "mapper/vector/fetch-inl.h"
#include "mapper/vector/lane_columns-inl.h"
#include "mapper/vector/number_columns-inl.h"
#include "mapper/vector/one_window-inl.h"
#include "mapper/vector/plane_ties-inl.h"
#include "mapper/vector/quotients-inl.h"
#include "mapper/vector/row_blocks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// What decides the near-ties of a column, as PlaneTies does those of a row.
template <class Column>
class ColumnTies {
 public:
  using Slab = typename Column::Slab;

  // From some pixels of a row and of those below it. The slab is biased_slab().
  HWY_INLINE ColumnTies(Slab slab, int32_t row, V32 px)
      : ColumnTies(at(&slab, row), slab_pixels(hn::Sub(px, hn::Set(D32(), slab.first_px)))) {}

  // In these rows those of the other one, of another slab.
  HWY_INLINE void take(const RowsBelow& rows, const ColumnTies& other) {
    u_.take(rows, other.u_);
    v_.take(rows, other.v_);
    d_.take(rows, other.d_);
  }
  HWY_INLINE void go_right() {
    u_.go_right();
    v_.go_right();
    d_.go_right();
  }
  HWY_INLINE void decide(int32_t px, const NearTies& near, V32* HWY_RESTRICT s,
                         V32* HWY_RESTRICT t) const {
    Decision<typename Column::Limbs>::decide(u_, v_, d_, px, near, s, t);
  }

  // By the whole parts.
  [[nodiscard]] HWY_INLINE Quotients u_by(V32 whole) const { return quotients(u_, whole); }
  [[nodiscard]] HWY_INLINE Quotients v_by(V32 whole) const { return quotients(v_, whole); }

 private:
  HWY_INLINE Quotients quotients(const typename Column::Numerator& number, V32 whole) const {
    const V32 biased = hn::Add(whole, hn::Set(D32(), kTexelBias));
    const ByParity<V64> n = number.from(0), d = d_.from(0);
    const V64 even = hn::And(hn::BitCast(D64(), biased), hn::Set(D64(), UINT32_MAX));
    const V64 odd = hn::ShiftRight<32>(hn::BitCast(D64(), biased));
    const auto rests = [](V64 of, V64 times, V64 divisor) HWY_ATTR {
      const V64 rest = hn::Sub(of, hn::Mul(times, divisor));
      return hn::BitCast(RestTag(), hn::Xor(rest, hn::Set(D64(), uint64_t{1} << 63)));
    };
    return {whole, rests(n.even, even, d.even), rests(n.odd, odd, d.odd)};
  }
  static HWY_INLINE const Slab& at(Slab* slab, int32_t row) {
    slab->go_to(row);
    return *slab;
  }
  HWY_INLINE ColumnTies(const Slab& slab, const ByParity<SlabPixels>& first)
      : u_(slab.u, first), v_(slab.v, first), d_(slab.d, first) {}

  typename Column::Numerator u_, v_;
  typename Column::Divisor d_;
};

// The slab with a row, its texels kTexelBias more.
template <class Slab>
[[nodiscard]] HWY_NOINLINE Slab biased_slab(const ExactMap& map, int32_t px, int32_t row) {
  Slab slab = Slab::of(map, px, row);
  using Unsigned = decltype(slab.u.start);
  constexpr auto kTimes = static_cast<Unsigned>(int128{-kTexelBias});
  slab.u.subtract(kTimes, slab.d);
  slab.v.subtract(kTimes, slab.d);
  return slab;
}

// The texels of columns: those of lanes, with near-ties decided,
template <class Column, class Lanes>
class DecidedColumns {
 public:
  HWY_INLINE DecidedColumns(const LowLanes& low, const ColumnTies<Column>& ties, const Lanes& lanes)
      : low_(low), ties_(ties), lanes_(lanes) {}

  [[nodiscard]] HWY_INLINE TexelVectors get() const { return low_.decided(ties_, 0, lanes_.get()); }
  HWY_INLINE void go_right() {
    ties_.go_right();
    lanes_.go_right();
  }
  [[nodiscard]] HWY_INLINE const ColumnTies<Column>& ties() const { return ties_; }

 private:
  LowLanes low_;
  ColumnTies<Column> ties_;
  Lanes lanes_;
};

// and those of a plane, by quotients from the first column on.
struct PlaneSteps {
  QuotientSum u, v;
};
class QuotientColumns {
 public:
  template <class Decided>
  HWY_INLINE QuotientColumns(const Decided& first, const PlaneSteps& steps)
      : QuotientColumns(first.ties(), first.get(), steps) {}

  [[nodiscard]] HWY_INLINE TexelVectors get() const { return {u_.whole, v_.whole}; }
  HWY_INLINE void go_right() {
    u_ = steps_.u.of(u_);
    v_ = steps_.v.of(v_);
  }

 private:
  template <class Ties>
  HWY_INLINE QuotientColumns(const Ties& ties, const TexelVectors& first, const PlaneSteps& steps)
      : u_(ties.u_by(first.s)), v_(ties.v_by(first.t)), steps_(steps) {}

  Quotients u_, v_;
  PlaneSteps steps_;
};

// Where the texels of a pixel of each of kLanes rows are, and of those right of them: columns of
// the rows.
struct PlaceColumns {
  HWY_ALIGN int32_t place[kLanes * kLanes];

  // Up to kLanes columns.
  template <class Address, class Columns>
  HWY_INLINE void find(int32_t count_px, const Extent& extent, Columns* columns) {
    for (int32_t px = 0; px < count_px; ++px) {
      const TexelVectors texels = columns->get();
      hn::Store(Address::place(texels.s, texels.t, extent), D32(), place + px * kLanes);
      columns->go_right();
    }
  }

  // The first pixels of a row, 0 or more, or none.
  template <class Pixel>
  HWY_INLINE void draw(int32_t row, const void* texels, int32_t count_px, Pixel* to) const {
    const auto draw_pixel = [&](int32_t px) HWY_ATTR __attribute__((always_inline)) {
      to[px] = texel_at<Pixel>(texels, place[px * kLanes + row]);
    };
    int32_t px = 0;
    for (; px + 4 <= count_px; px += 4) {
      draw_pixel(px);
      draw_pixel(px + 1);
      draw_pixel(px + 2);
      draw_pixel(px + 3);
    }
    for (; px < count_px; ++px) draw_pixel(px);
  }
};

// Some rows, up to kLanes of them.
template <class Pixel, class Address, class Columns>
HWY_INLINE void draw_block(const SpanBatch& batch, const RowBlock& rows, Columns from,
                           const Surface& surface) {
  const Extent extent = extent_of(surface.texture);
  PlaceColumns columns;
  for (int32_t from_px = 0; from_px < rows.widest_px; from_px += kLanes) {
    columns.find<Address>(HWY_MIN(kLanes, rows.widest_px - from_px), extent, &from);
    for (int32_t i = rows.first; i < rows.end; ++i) {
      const Span span = batch.span(i);
      auto* const to = reinterpret_cast<Pixel*>(first_pixel(surface, span));
      columns.draw(i - rows.first, surface.texture.texels,
                   HWY_MIN(kLanes, span.width_px() - from_px), to + from_px);
    }
  }
}

// Whether narrow rows are so many that columns cost less than their vectors: as many as there are,
// and one more a row.
[[nodiscard]] HWY_INLINE bool pays_columns(const SpanBatch& batch) {
  const int32_t blocks = (batch.rows + kLanes - 1) / kLanes;
  const int32_t vectors = (batch.widest_px + kLanes - 1) / kLanes;
  return is_narrow(batch) && batch.rows > 1 &&
         batch.widest_px * blocks <= batch.rows * (vectors + 1);
}

// The same of any rows that have a map each: to find one for its vectors was measured to cost as
// much as so many columns, whatever their lanes are.
[[nodiscard]] HWY_INLINE bool pays_columns_of_maps(const SpanBatch& batch) {
  constexpr int32_t kColumnsARow = 16;
  if (batch.rows == 1) return false;  // a slab takes the maps of three
  int32_t columns = 0;
  for (int32_t i = 0; i < batch.rows; i += kLanes) {
    columns += block_of(batch, i, HWY_MIN(i + kLanes, batch.rows)).widest_px;
  }
  return columns <= batch.rows * kColumnsARow;
}

// Whether rows have so few pixels that the boundaries between these texels cost more than columns.
[[nodiscard]] HWY_INLINE bool beat_boundaries(const SpanBatch& batch, const TexelRanges& texels) {
  constexpr int32_t kLanesOfOne = 8;
  return batch.widest_px * kLanesOfOne <= (texels.s.count() + texels.t.count() - 2) * kLanes;
}

// What decides the near-ties of kLanes rows at a time, from slab to slab. 64 bits must tell on
// which sides they lie, as is_one_limb_enough().
class TieColumns {
 public:
  HWY_INLINE TieColumns(const ExactMap& map, const SpanBatch& batch) : map_(map), batch_(batch) {}

  // From some pixels of so many rows from an index in the batch on. Cheapest in turn.
  [[nodiscard]] HWY_INLINE ColumnTies<OneLimbColumn> from(int32_t index, int32_t count, V32 px) {
    const int32_t row = batch_.first_row + index, end_row = row + count;
    if (!slab_.has(row)) find(row);
    ColumnTies<OneLimbColumn> ties(slab_, row, px);
    while (slab_.end_row < end_row) {
      const int32_t below = slab_.end_row - row;
      find(slab_.end_row);
      ties.take(rows_below(below), {slab_, row, px});
    }
    return ties;
  }

 private:
  HWY_INLINE void find(int32_t row) {
    const Span span = batch_.span(row - batch_.first_row);
    slab_ = biased_slab<OneLimbColumn::Slab>(map_, span.left_px, row);
  }

  const ExactMap& map_;
  const SpanBatch& batch_;
  OneLimbColumn::Slab slab_;
};

// The rows of a batch from an index on by columns_of(ties, row, px), those of kLanes rows from some
// pixels on. 64 bits must tell, as TieColumns has it.
template <class Pixel, class Address, class ColumnsOf>
HWY_NOINLINE void draw_columns(const SpanBatch& batch, int32_t first_index, const ExactMap& map,
                               const Surface& surface, const ColumnsOf& columns_of) {
  TieColumns ties(map, batch);
  for (int32_t i = first_index; i < batch.rows; i += kLanes) {
    const int32_t end = HWY_MIN(i + kLanes, batch.rows);
    const auto is_row = hn::Lt(hn::Iota(D32(), i), hn::Set(D32(), end));
    const V32 left_px = hn::IfThenElseZero(is_row, hn::LoadU(D32(), batch.left_px.data() + i));
    const auto of_block = columns_of(ties.from(i, end - i, left_px), batch.first_row + i, left_px);
    draw_block<Pixel, Address>(batch, block_of(batch, i, end), of_block, surface);
  }
}

// The columns of lanes that lack less than low's.
template <class LanesOfRows>
class DecidedColumnsOf {
 public:
  HWY_INLINE DecidedColumnsOf(const LowLanes& low, const LanesOfRows& lanes)
      : low_(low), lanes_(lanes) {}
  HWY_INLINE DecidedColumns<OneLimbColumn, LaneColumns> operator()(
      const ColumnTies<OneLimbColumn>& ties, int32_t row, V32 px) const {
    return {low_, ties, lanes_.from(row, px)};
  }

 private:
  LowLanes low_;
  LanesOfRows lanes_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
