// Near-ties of narrow rows, column by column: a lane is a row, so that rows share what they would
// cost one by one. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_TIE_COLUMNS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_TIE_COLUMNS_INL_H
#undef SELVAGE_VECTOR_TIE_COLUMNS_INL_H
#else
#define SELVAGE_VECTOR_TIE_COLUMNS_INL_H
#endif

#include "mapper/exact_slab.h"
#include "mapper/vector_affine_strip-inl.h"
#include "mapper/vector_fetch-inl.h"
#include "mapper/vector_plane_ties-inl.h"
#include "mapper/vector_row_blocks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// The first pixels of half of kLanes rows, counted from a slab's first row and from its column.
struct SlabPixels {
  V64 down, pairs, right;  // pairs of the rows above

  HWY_INLINE SlabPixels(V64 down_px, V64 right_px)
      : down(down_px),
        pairs(hn::ShiftRight<1>(hn::Mul(down_px, hn::Sub(down_px, hn::Set(D64(), 1))))),
        right(right_px) {}
};

[[nodiscard]] HWY_INLINE ByParity<SlabPixels> slab_pixels(int32_t down_px, V32 right_px) {
  const D64 d;
  const hn::RebindToSigned<D64> wide;
  const V64 even_down =
      hn::Add(hn::Set(d, static_cast<uint64_t>(down_px)), hn::ShiftLeft<1>(hn::Iota(d, 0)));
  const auto odd_right = hn::BitCast(wide, right_px), even_right = hn::ShiftLeft<32>(odd_right);
  return {{even_down, hn::BitCast(d, hn::ShiftRight<32>(even_right))},
          {hn::Add(even_down, hn::Set(d, 1)), hn::BitCast(d, hn::ShiftRight<32>(odd_right))}};
}

// A number of a slab at a pixel of each of kLanes rows, modulo 2^64, and its steps to the next
// ones.
class NumberColumn {
 public:
  HWY_INLINE NumberColumn(const ShortSlab::Line& line, const ByParity<SlabPixels>& first)
      : even_(line, first.even), odd_(line, first.odd) {}

  [[nodiscard]] HWY_INLINE ByParity<V64> from(int32_t /*px*/) const { return {even_.at, odd_.at}; }
  HWY_INLINE void go_right() {
    even_.go_right();
    odd_.go_right();
  }

 private:
  struct Half {
    HWY_INLINE Half(const ShortSlab::Line& line, const SlabPixels& px) {
      const auto plus = [](V64 sum, V64 times, uint64_t by)
                            HWY_ATTR { return hn::Add(sum, hn::Mul(times, hn::Set(D64(), by))); };
      step = plus(hn::Set(D64(), line.step), px.down, line.turn);
      at = plus(plus(hn::Set(D64(), line.start), px.down, line.down), px.pairs, line.bend);
      at = hn::Add(at, hn::Mul(px.right, step));
    }
    HWY_INLINE void go_right() { at = hn::Add(at, step); }

    V64 at, step;
  };
  Half even_, odd_;
};

// What decides the near-ties of a column, as PlaneTies does those of a row.
class ColumnTies {
 public:
  // The slab's texels are kTexelBias more.
  HWY_INLINE ColumnTies(const ShortSlab& slab, const ByParity<SlabPixels>& first)
      : u_(slab.u, first), v_(slab.v, first), d_(slab.d, first) {}

  HWY_INLINE void go_right() {
    u_.go_right();
    v_.go_right();
    d_.go_right();
  }
  HWY_INLINE void decide(int32_t px, const NearTies& near, V32* HWY_RESTRICT s,
                         V32* HWY_RESTRICT t) const {
    Decision<OneLimb>::decide(u_, v_, d_, px, near, s, t);
  }

 private:
  NumberColumn u_, v_, d_;
};

// One coordinate's lanes at a pixel of each of kLanes rows, and their steps to the next ones.
class LaneColumn {
 public:
  HWY_INLINE LaneColumn(const WideLanes& at_fx32, const WideLanes& step_fx32)
      : at_(at_fx32), step_(step_fx32) {}

  [[nodiscard]] HWY_INLINE V32 floors_fx16() const { return at_.floors_fx16(); }
  HWY_INLINE void go_right() { at_ = {sum(at_.low, step_.low), sum(at_.high, step_.high)}; }

 private:
  static HWY_INLINE V32 sum(V32 at, V32 step) {
    return hn::BitCast(D32(), hn::Add(hn::BitCast(D64(), at), hn::BitCast(D64(), step)));
  }

  WideLanes at_, step_;
};
struct LaneColumns {
  LaneColumn u, v;
};

// Those of a plane's rows.
class PlaneColumns {
 public:
  explicit HWY_INLINE PlaneColumns(const AffineField& field) : field_(field) {}

  // From pixels of kLanes rows on, which are not negative.
  [[nodiscard]] HWY_INLINE LaneColumns from(int32_t row, V32 px) const {
    const Lane start = field_.at(0, row), right = field_.step_x, down = field_.step_y;
    const auto column = [&](int64_t start_fx32, int64_t right_fx32, int64_t down_fx32) HWY_ATTR {
      const V32 step = hn::BitCast(D32(), hn::Set(D64(), static_cast<uint64_t>(right_fx32)));
      return LaneColumn(WideAnchorLine(start_fx32, right_fx32, down_fx32).next(px), {step, step});
    };
    return {column(start.u_fx32, right.u_fx32, down.u_fx32),
            column(start.v_fx32, right.v_fx32, down.v_fx32)};
  }

 private:
  AffineField field_;
};

// Those of rows that each have a map of their own.
class RuledColumns {
 public:
  HWY_INLINE RuledColumns(const RuledRows& rows, int32_t first_row)
      : rows_(rows), first_row_(first_row) {}

  // From the rows' first pixels on.
  [[nodiscard]] HWY_INLINE LaneColumns from(int32_t row, V32 /*px*/) const {
    HWY_ALIGN int64_t start_u[kLanes]{}, start_v[kLanes]{}, step_u[kLanes]{}, step_v[kLanes]{};
    const int32_t index = row - first_row_, count = HWY_MIN(kLanes, kRowsPerBatch - index);
    for (int32_t k = 0; k < count; ++k) {
      const auto i = static_cast<size_t>(index + k);
      start_u[k] = rows_.start[i].u_fx32;
      start_v[k] = rows_.start[i].v_fx32;
      step_u[k] = rows_.step[i].u_fx32;
      step_v[k] = rows_.step[i].v_fx32;
    }
    return {{wide(start_u), wide(step_u)}, {wide(start_v), wide(step_v)}};
  }

 private:
  static HWY_INLINE WideLanes wide(const int64_t* lanes_fx32) {
    const hn::RebindToSigned<D64> d;
    return {hn::BitCast(D32(), hn::Load(d, lanes_fx32)),
            hn::BitCast(D32(), hn::Load(d, lanes_fx32 + kLanes / 2))};
  }

  const RuledRows& rows_;
  int32_t first_row_;
};

// Where the texels of a pixel of each of kLanes rows are, and of those right of them: columns of
// the rows.
struct PlaceColumns {
  HWY_ALIGN int32_t place[kLanes * kLanes];

  // The first ones of a row.
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

// Some rows of a slab, up to kLanes of them.
template <class Pixel, class Address, class LanesOfRows>
HWY_INLINE void draw_block(const SpanBatch& batch, const RowBlock& rows, const ShortSlab& slab,
                           const LowLanes& low, const LanesOfRows& lanes_of_rows,
                           const Surface& surface) {
  const D32 d;
  const Extent extent = extent_of(surface.texture);
  const int32_t first_row = batch.first_row + rows.first;
  const V32 left_px = hn::LoadU(d, batch.left_px.data() + rows.first);
  const V32 right_px = hn::Sub(left_px, hn::Set(d, slab.first_px));
  ColumnTies ties(slab, slab_pixels(first_row - slab.first_row, right_px));
  LaneColumns lanes = lanes_of_rows.from(first_row, left_px);
  PlaceColumns columns;
  for (int32_t from_px = 0; from_px < rows.widest_px; from_px += kLanes) {
    const int32_t count_px = HWY_MIN(kLanes, rows.widest_px - from_px);
    for (int32_t px = 0; px < count_px; ++px) {
      const TexelVectors texels =
          low.decided(ties, px, {lanes.u.floors_fx16(), lanes.v.floors_fx16()});
      hn::Store(Address::place(texels.s, texels.t, extent), d, columns.place + px * kLanes);
      ties.go_right();
      lanes.u.go_right();
      lanes.v.go_right();
    }
    for (int32_t i = rows.first; i < rows.end; ++i) {
      const Span span = batch.span(i);
      auto* const to = reinterpret_cast<Pixel*>(first_pixel(surface, span));
      columns.draw(i - rows.first, surface.texture.texels,
                   HWY_MIN(kLanes, span.width_px() - from_px), to + from_px);
    }
  }
}

// The rows of a batch from an index on, narrow ones, by lanes that lack less than low's. 64 bits
// must tell on which sides near-ties lie, as is_one_limb_enough().
template <class Pixel, class Address, class LanesOfRows>
HWY_NOINLINE void draw_columns(const SpanBatch& batch, int32_t first_index, const LowLanes& low,
                               const LanesOfRows& lanes_of_rows, const ExactMap& map,
                               const Surface& surface) {
  ShortSlab slab;
  for (int32_t i = first_index; i < batch.rows;) {
    const Span first = batch.span(i);
    if (!slab.has(first.row)) {
      slab = ShortSlab::of(map, first.left_px, first.row);
      slab.u.subtract(uint64_t{0} - kTexelBias, slab.d);
      slab.v.subtract(uint64_t{0} - kTexelBias, slab.d);
    }
    const int32_t rows_left = HWY_MIN(batch.rows - i, slab.end_row - first.row);
    const int32_t end = i + HWY_MIN(kLanes, rows_left);
    draw_block<Pixel, Address>(batch, block_of(batch, i, end), slab, low, lanes_of_rows, surface);
    i = end;
  }
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
