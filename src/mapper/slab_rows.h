// Exact rows of slabs, asked for one after another: by differences from a slab's first three.
#pragma once

#include <array>
#include <cstdint>

#include "mapper/exact_row.h"
#include "mapper/slab.h"

namespace selvage::mapper {

// A number that is linear along each row; at a column it is quadratic in the row, and its step is
// linear. Modulo 2^128.
class SlabLine {
 public:
  SlabLine() = default;
  // From a row and the two below it, all from the same column on.
  SlabLine(const ExactLine& row, const ExactLine& below, const ExactLine& next)
      : start_(row.start),
        down_(below.start - row.start),
        bend_(next.start - below.start - down_),
        step_(row.step),
        turn_(below.step - row.step) {}

  // So many rows below the first one, from so many pixels right of the column on: rows >= 0.
  [[nodiscard]] ExactLine row(int32_t rows, int32_t right_px) const {
    const auto n = static_cast<uint32_t>(rows);
    const uint64_t pairs = uint64_t{n} * (n - 1) / 2;
    const uint128 step = step_ + n * turn_;
    const uint128 right = static_cast<uint128>(int128{right_px}) * step;
    return {start_ + n * down_ + pairs * bend_ + right, step};
  }

 private:
  uint128 start_, down_, bend_;  // at the column: at first, to the next row, and how much more then
  uint128 step_, turn_;          // to the next pixel: in the first row, and how much more a row
};

class SlabRows {
 public:
  SlabRows() = default;
  SlabRows(const Slab& slab, int32_t first_px) : first_px_(first_px), first_row_(slab.first_row) {
    std::array<ExactRow, 3> rows;
    for (int32_t i = 0; i < 3; ++i) {
      const int32_t row = slab.first_row + i;  // a slab may end before: its edges go on
      rows[static_cast<size_t>(i)] = row_by(SpanMap(slab.a.at(row), slab.b.at(row)), first_px);
    }
    const auto line = [&](ExactLine ExactRow::*of) {
      return SlabLine(rows[0].*of, rows[1].*of, rows[2].*of);
    };
    u_ = line(&ExactRow::u);
    v_ = line(&ExactRow::v);
    d_ = line(&ExactRow::d);
  }

  // Of a pixel of the slab, and the pixels right of it.
  [[nodiscard]] ExactRow row_from(int32_t px, int32_t row) const {
    const int32_t down = row - first_row_, right_px = px - first_px_;
    const ExactRow found{u_.row(down, right_px), v_.row(down, right_px), d_.row(down, right_px)};
    // Where edge `a` is the right one, all signs are changed.
    return static_cast<int128>(found.d.start) > 0 ? found : negative(found);
  }

 private:
  [[nodiscard]] static ExactRow negative(const ExactRow& row) {
    const auto line = [](const ExactLine& of) { return ExactLine{0 - of.start, 0 - of.step}; };
    return {line(row.u), line(row.v), line(row.d)};
  }

  int32_t first_px_, first_row_;
  SlabLine u_, v_, d_;
};

// The rows of a ruled map, which it refers to. They may be asked for in any order; most cheaply one
// slab after another.
class RuledRowFinder {
 public:
  explicit RuledRowFinder(const RuledMap& map) : map_(&map) {}

  // Of a pixel of the polygon, and the pixels right of it.
  [[nodiscard]] ExactRow row_from(int32_t px, int32_t row) {
    if (row < first_row_ || row >= end_row_) start(map_->slab_of(row));
    if (asked_ < kWorth) {
      ++asked_;
      return row_by(map_->at(row), px);
    }
    if (asked_ == kWorth) find(map_->slab_of(row), px);
    return rows_.row_from(px, row);
  }

 private:
  // Differences are worth finding after so many rows.
  static constexpr int32_t kWorth = 2;

  void start(const Slab& slab) {
    first_row_ = slab.first_row;
    end_row_ = slab.end_row;
    asked_ = 0;
  }
  void find(const Slab& slab, int32_t px) {
    rows_ = SlabRows(slab, px);
    ++asked_;
  }

  const RuledMap* map_;
  int32_t first_row_ = 0, end_row_ = 0;  // of the slab that was last asked of
  int32_t asked_ = 0;
  SlabRows rows_;
};

}  // namespace selvage::mapper
