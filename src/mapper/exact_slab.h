// A slab's exact rows, by differences from its first three.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "mapper/exact_row.h"
#include "mapper/slab.h"

namespace selvage::mapper {

// A number that is linear along each row; at a column it is quadratic in the row, and its step is
// linear. Modulo 2^128, or 2^64.
template <class Unsigned>
struct SlabLine {
  Unsigned start, down, bend;  // at the column: at first, to the next row, and how much more then
  Unsigned step, turn;         // to the next pixel: in the first row, and how much more a row

  SlabLine() = default;
  // From a row and the two below it, all from the same column on.
  SlabLine(const ExactLine& row, const ExactLine& below, const ExactLine& next)
      : start(row.start),
        down(below.start - row.start),
        bend(next.start - below.start - down),
        step(row.step),
        turn(below.step - row.step) {}
  // From two rows of a plane.
  SlabLine(const ExactLine& row, const ExactLine& below)
      : start(row.start), down(below.start - row.start), bend(0), step(row.step), turn(0) {}
  // The low bits of one.
  template <class Wider>
  explicit SlabLine(const SlabLine<Wider>& line)
      : start(static_cast<Unsigned>(line.start)),
        down(static_cast<Unsigned>(line.down)),
        bend(static_cast<Unsigned>(line.bend)),
        step(static_cast<Unsigned>(line.step)),
        turn(static_cast<Unsigned>(line.turn)) {}

  // So many rows below the first one, from so many pixels right of the column on: rows >= 0.
  [[nodiscard]] ExactLine row(int32_t rows, int32_t right_px) const {
    const auto n = static_cast<uint32_t>(rows);
    const uint64_t pairs = uint64_t{n} * (n - 1) / 2;
    const Unsigned row_step = step + n * turn;
    const Unsigned right = static_cast<Unsigned>(int64_t{right_px}) * row_step;
    return {start + n * down + pairs * bend + right, row_step};
  }

  // The first one.
  [[nodiscard]] ExactLine first_row(int32_t right_px) const {
    return {start + static_cast<Unsigned>(int64_t{right_px}) * step, step};
  }

  // Begins with the next row, or with one so many below the first one or, below 0, above it.
  void go_down() {
    start += down;
    down += bend;
    step += turn;
  }
  void go_down(int32_t rows) {
    const int64_t n = rows;
    const auto signed_sum = [](Unsigned to, int64_t times, Unsigned by) {
      return to + static_cast<Unsigned>(times) * by;
    };
    start = signed_sum(signed_sum(start, n, down), n * (n - 1) / 2, bend);
    down = signed_sum(down, n, bend);
    step = signed_sum(step, n, turn);
  }

  void subtract(Unsigned times, const SlabLine& line) {
    start -= times * line.start;
    down -= times * line.down;
    bend -= times * line.bend;
    step -= times * line.step;
    turn -= times * line.turn;
  }
  void negate() {
    for (Unsigned* const number : {&start, &down, &bend, &step, &turn}) *number = 0 - *number;
  }
};

class ExactSlab {
 public:
  using Line = SlabLine<uint128>;

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
      const auto [a, b] = slab.at(row);
      rows[static_cast<size_t>(i)] = row_by(SpanMap(a, b), first_px);
    }
    const auto line = [&](ExactLine ExactRow::*of) {
      return Line(rows[0].*of, rows[1].*of, rows[2].*of);
    };
    u_ = line(&ExactRow::u);
    v_ = line(&ExactRow::v);
    d_ = line(&ExactRow::d);
  }

  // Numerators and denominator from the first row and the column on.
  [[nodiscard]] const Line& u() const { return u_; }
  [[nodiscard]] const Line& v() const { return v_; }
  [[nodiscard]] const Line& d() const { return d_; }

  [[nodiscard]] bool has(int32_t row) const { return row >= first_row_ && row < end_row_; }

  // Of a pixel of the slab, and the pixels right of it. Edges may change sides from row to row,
  // which changes all signs: then those of all rows are changed, to stay so below.
  [[nodiscard, gnu::always_inline]] inline ExactRow row_from(int32_t px, int32_t row) {
    const int32_t down = row - first_row_, right_px = px - first_px_;
    if (static_cast<int128>(d_.row(down, right_px).start) < 0) {
      for (Line* const line : {&u_, &v_, &d_}) line->negate();
    }
    return {u_.row(down, right_px), v_.row(down, right_px), d_.row(down, right_px)};
  }

 private:
  int32_t first_px_ = 0, first_row_ = 0, end_row_ = 0;
  Line u_, v_, d_;
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

// A slab where no two edges change sides, so that d > 0 at its pixels, or a plane; of its numbers,
// the low bits.
template <class Unsigned>
struct DirectedSlab {
  using Line = SlabLine<Unsigned>;

  // Of no row.
  DirectedSlab() = default;
  // The one with a row of the map; by differences at a column, whichever.
  DirectedSlab(const RuledMap& map, int32_t px, int32_t of_row) : first_px(px) {
    const Slab slab = *from_left_to_right(map.slab_of(of_row));
    const ExactSlab rows(slab, px);
    first_row = row = slab.first_row;
    end_row = slab.end_row;
    u = Line(rows.u());
    v = Line(rows.v());
    d = Line(rows.d());
  }
  // Of a plane: one of its rows from a column on, and the one below.
  DirectedSlab(const ExactRows& rows, int32_t px, int32_t of_row)
      : first_px(px),
        first_row(INT32_MIN),
        end_row(INT32_MAX),
        row(of_row),
        u(ExactSlab::Line(rows.row.u, rows.below.u)),
        v(ExactSlab::Line(rows.row.v, rows.below.v)),
        d(ExactSlab::Line(rows.row.d, rows.below.d)) {}
  // Whichever the map is.
  static DirectedSlab of(const ExactMap& map, int32_t px, int32_t row) {
    return map.is_ruled() ? DirectedSlab(map.ruled(), px, row)
                          : DirectedSlab(map.rows_from(px, row), px, row);
  }

  [[nodiscard]] bool has(int32_t of_row) const { return of_row >= first_row && of_row < end_row; }
  // Cheapest in turn.
  void go_to(int32_t to_row) {
    for (Line* const line : {&u, &v, &d}) {
      if (to_row == row + 1) {
        line->go_down();
      } else {
        line->go_down(to_row - row);
      }
    }
    row = to_row;
  }

  int32_t first_px = 0, first_row = 0, end_row = 0;
  int32_t row = 0;  // that the lines begin with, at the column
  Line u, v, d;
};

// Whether each slab of a map is a DirectedSlab.
[[nodiscard]] inline bool is_directed(const RuledMap& map) {
  return std::ranges::all_of(map.slabs(),
                             [](const Slab& slab) { return from_left_to_right(slab).has_value(); });
}

// The low 64 bits of the rows of a map that is_directed().
class ShortRuledRowFinder {
 public:
  explicit ShortRuledRowFinder(const RuledMap& map) : map_(&map) {}

  // As RuledRowFinder.
  [[nodiscard]] ExactRow row_from(int32_t px, int32_t row) {
    if (!slab_.has(row)) slab_ = DirectedSlab<uint64_t>(*map_, px, row);
    slab_.go_to(row);
    const int32_t right_px = px - slab_.first_px;
    return {slab_.u.first_row(right_px), slab_.v.first_row(right_px), slab_.d.first_row(right_px)};
  }

 private:
  const RuledMap* map_;
  DirectedSlab<uint64_t> slab_;  // that was last asked of
};

}  // namespace selvage::mapper
