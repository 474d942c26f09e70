// What decides near-ties: the exact map along a row, whichever map it is.
#pragma once

#include <algorithm>
#include <cstdint>

#include "mapper/number.h"
#include "mapper/plane.h"
#include "mapper/projective_plane.h"
#include "mapper/slab.h"
#include "mapper/span.h"

namespace selvage::mapper {

// A coordinate's numerator at some pixel of a row, and how much it changes to the next one: i >= 0.
// Modulo 2^128: numbers may leave their range on pixels that nobody asks for.
struct ExactLine {
  uint128 start, step;

  [[nodiscard]] uint128 at(int32_t i) const { return at<uint128>(i); }
  template <class Unsigned>
  [[nodiscard]] Unsigned at(int32_t i) const {
    const Unsigned steps = static_cast<uint32_t>(i);
    return static_cast<Unsigned>(start) + steps * static_cast<Unsigned>(step);
  }
};

// Whether n / d is at or beyond a whole number that is no further from it than one: the sign of one
// integer in [-d, d], without a division.
[[nodiscard]] inline bool reaches(uint128 n, uint128 d, int32_t whole) {
  return static_cast<int128>(n - static_cast<uint128>(int128{whole}) * d) >= 0;
}
// The same by the low halves, where that integer is in [-2^63, 2^63).
[[nodiscard]] inline bool reaches(uint64_t n, uint64_t d, int32_t whole) {
  return static_cast<int64_t>(n - static_cast<uint64_t>(int64_t{whole}) * d) >= 0;
}

// u = u.at(i) / d.at(i) texels, and likewise v, at the i-th pixel of a span.
struct ExactRow {
  ExactLine u, v, d;

  // Whether a coordinate is at or beyond a whole texel that is no further from it than one.
  [[nodiscard]] bool reaches(const ExactLine& coordinate, int32_t i, int32_t texel) const {
    return mapper::reaches(coordinate.at(i), d.at(i), texel);
  }

  // Whether the low 64 bits of n and d tell the sign that decides, at so many pixels, near-ties
  // that are no further from the whole texel than 2^-spare_bits: that of an integer no greater than
  // d / 2^spare_bits.
  [[nodiscard]] bool is_short(int32_t width_px, int spare_bits) const {
    return (std::max(d.start, d.at(width_px - 1)) >> (62 + spare_bits)) == 0;
  }

  // What d is where u and v are in units of 2^-bits texel, up to 16.
  [[nodiscard]] ExactLine finer_d(int bits) const {
    const auto less = [&](uint128 a) {
      return static_cast<uint128>(static_cast<int128>(a) >> bits);  // a multiple of 2^16
    };
    return {less(d.start), less(d.step)};
  }
};

[[nodiscard]] inline ExactLine exact_line(int128 start, int128 step) {
  return {static_cast<uint128>(start), static_cast<uint128>(step)};
}
[[nodiscard]] inline ExactRow row_by(const SpanMap& map, int32_t px) {
  return {exact_line(map.u_numerator(px), map.u_numerator_step()),
          exact_line(map.v_numerator(px), map.v_numerator_step()),
          exact_line(map.denominator(px), map.denominator_step())};
}

// A row, and the one below it from the same column on.
struct ExactRows {
  ExactRow row, below;
};

// Refers to the map.
class ExactMap {
 public:
  explicit ExactMap(const SpanMap& map) : map_(&map), row_from_(row_of_span) {}
  explicit ExactMap(const Plane& plane) : map_(&plane), row_from_(row_of_plane) {}
  explicit ExactMap(const ProjectivePlane& plane)
      : map_(&plane), row_from_(row_of_projective_plane) {}
  explicit ExactMap(const RuledMap& map) : map_(&map), row_from_(row_of_ruled), is_ruled_(true) {}
  // Of rows that each have a map of their own, as rows.row_from(px, row) finds them.
  template <class Rows>
  [[nodiscard]] static ExactMap of_rows(const Rows& rows) {
    const auto find = [](const void* of, int32_t px, int32_t row) {
      return static_cast<const Rows*>(of)->row_from(px, row);
    };
    return {&rows, find, true};
  }

  // Of a pixel of the polygon, and the pixels right of it.
  [[nodiscard]] ExactRow row_from(int32_t px, int32_t row) const {
    return row_from_(map_, px, row);
  }
  // The one below it, too, where both are of one map; else the same twice.
  [[nodiscard]] ExactRows rows_from(int32_t px, int32_t row) const {
    const ExactRow here = row_from(px, row);
    return {here, is_ruled_ ? here : row_from(px, row + 1)};
  }
  // Whether each row has a map of its own.
  [[nodiscard]] bool is_ruled() const { return is_ruled_; }
  // What it was made from, where that is a RuledMap.
  [[nodiscard]] const RuledMap& ruled() const { return *static_cast<const RuledMap*>(map_); }

 private:
  using RowFrom = ExactRow (*)(const void* of, int32_t px, int32_t row);
  ExactMap(const void* map, RowFrom find, bool is_ruled)
      : map_(map), row_from_(find), is_ruled_(is_ruled) {}

  [[nodiscard]] static ExactRow row_of_span(const void* of, int32_t px, int32_t /*row*/) {
    return row_by(*static_cast<const SpanMap*>(of), px);
  }
  [[nodiscard]] static ExactRow row_of_ruled(const void* of, int32_t px, int32_t row) {
    return row_by(static_cast<const RuledMap*>(of)->at(row), px);
  }
  [[nodiscard]] static ExactRow row_of_plane(const void* of, int32_t px, int32_t row) {
    const auto& plane = *static_cast<const Plane*>(of);
    const auto [u, u_step] = plane.u_numerator(px, row);
    const auto [v, v_step] = plane.v_numerator(px, row);
    return {exact_line(u, u_step), exact_line(v, v_step), exact_line(plane.denominator(), 0)};
  }
  [[nodiscard]] static ExactRow row_of_projective_plane(const void* of, int32_t px, int32_t row) {
    const auto& plane = *static_cast<const ProjectivePlane*>(of);
    return {exact_line(plane.u_numerator(px, row), plane.u_numerator_step()),
            exact_line(plane.v_numerator(px, row), plane.v_numerator_step()),
            exact_line(plane.denominator(px, row), plane.denominator_step())};
  }

  const void* map_;
  RowFrom row_from_;
  bool is_ruled_ = false;
};

// The exact row of a span, once somebody asks for it.
class RowOnDemand {
 public:
  RowOnDemand(const ExactMap& map, const Span& span) : map_(&map), span_(span) {}

  [[nodiscard]] bool is_known() const { return is_known_; }
  // Its near-ties are no further from a whole texel than 2^-spare_bits.
  void find(int spare_bits) {
    row_ = map_->row_from(span_.left_px, span_.row);
    is_short_ = row_.is_short(span_.width_px(), spare_bits);
    is_known_ = true;
  }
  // If known:
  [[nodiscard]] const ExactRow& get() const { return row_; }
  [[nodiscard]] bool is_short() const { return is_short_; }

 private:
  const ExactMap* map_;
  Span span_;
  bool is_known_ = false;
  // If known:
  bool is_short_;
  ExactRow row_;
};

}  // namespace selvage::mapper
