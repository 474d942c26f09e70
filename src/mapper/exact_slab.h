// A slab's exact rows, by differences from its first three.
#pragma once

#include <array>
#include <cstdint>

#include "mapper/exact_row.h"
#include "mapper/slab.h"

namespace selvage::mapper {

// A number that is linear along each row; at a column it is quadratic in the row, and its step is
// linear. Modulo 2^128.
struct SlabLine {
  uint128 start, down, bend;  // at the column: at first, to the next row, and how much more then
  uint128 step, turn;         // to the next pixel: in the first row, and how much more a row

  SlabLine() = default;
  // From a row and the two below it, all from the same column on.
  SlabLine(const ExactLine& row, const ExactLine& below, const ExactLine& next)
      : start(row.start),
        down(below.start - row.start),
        bend(next.start - below.start - down),
        step(row.step),
        turn(below.step - row.step) {}

  // So many rows below the first one, from so many pixels right of the column on: rows >= 0.
  [[nodiscard]] ExactLine row(int32_t rows, int32_t right_px) const {
    const auto n = static_cast<uint32_t>(rows);
    const uint64_t pairs = uint64_t{n} * (n - 1) / 2;
    const uint128 row_step = step + n * turn;
    const uint128 right = static_cast<uint128>(int128{right_px}) * row_step;
    return {start + n * down + pairs * bend + right, row_step};
  }

  void negate() {
    for (uint128* const number : {&start, &down, &bend, &step, &turn}) *number = 0 - *number;
  }
};

class ExactSlab {
 public:
  // Of no row.
  ExactSlab() = default;
  // By differences at a column, whichever.
  ExactSlab(const Slab& slab, int32_t first_px)
      : first_px_(first_px), first_row_(slab.first_row), end_row_(slab.end_row) {
    // A slab may end before. Two rows, or three pixels, beyond its end an edge's values are no more
    // than they would be if it were six pixels higher.
    static_assert(kEdgeBits + kPositionBits + kSubpixelBits + 2 < 127 && kWeightBits + 3 < 63);
    std::array<ExactRow, 3> rows;
    for (int32_t i = 0; i < 3; ++i) {
      const int32_t row = first_row_ + i;
      rows[static_cast<size_t>(i)] = row_by(SpanMap(slab.a.at(row), slab.b.at(row)), first_px);
    }
    const auto line = [&](ExactLine ExactRow::*of) {
      return SlabLine(rows[0].*of, rows[1].*of, rows[2].*of);
    };
    u_ = line(&ExactRow::u);
    v_ = line(&ExactRow::v);
    d_ = line(&ExactRow::d);
  }

  // Numerators and denominator from the first row and the column on.
  [[nodiscard]] const SlabLine& u() const { return u_; }
  [[nodiscard]] const SlabLine& v() const { return v_; }
  [[nodiscard]] const SlabLine& d() const { return d_; }

  [[nodiscard]] bool has(int32_t row) const { return row >= first_row_ && row < end_row_; }

  // Of a pixel of the slab, and the pixels right of it. Edges may change sides from row to row,
  // which changes all signs: then those of all rows are changed, to stay so below.
  [[nodiscard, gnu::always_inline]] inline ExactRow row_from(int32_t px, int32_t row) {
    const int32_t down = row - first_row_, right_px = px - first_px_;
    if (static_cast<int128>(d_.row(down, right_px).start) < 0) {
      for (SlabLine* const line : {&u_, &v_, &d_}) line->negate();
    }
    return {u_.row(down, right_px), v_.row(down, right_px), d_.row(down, right_px)};
  }

 private:
  int32_t first_px_ = 0, first_row_ = 0, end_row_ = 0;
  SlabLine u_, v_, d_;
};

// The rows of a ruled map, which it refers to, slab by slab.
class RuledRowFinder {
 public:
  explicit RuledRowFinder(const RuledMap& map) : map_(&map) {}

  // Of a pixel of the map, and the pixels right of it. Cheapest in turn.
  [[nodiscard, gnu::always_inline]] inline ExactRow row_from(int32_t px, int32_t row) const {
    if (!rows_.has(row)) rows_ = ExactSlab(map_->slab_of(row), px);
    return rows_.row_from(px, row);
  }

 private:
  const RuledMap* map_;
  mutable ExactSlab rows_;  // of the slab that was last asked of
};

}  // namespace selvage::mapper
