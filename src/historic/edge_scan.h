// An edge of the two-stage mapper: where it is in the target and, in step with that, in the source.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "mapper/polygon.h"
#include "selvage.h"

namespace selvage::historic {

// a / b as the sources divide 16.16 numbers: toward zero. Here a and b are of one scale.
[[nodiscard]] constexpr int64_t fixed_div(int64_t a, int64_t b) { return a / b; }

// How far along its first step a walk starts, in halves of it: abrash56 none, abrash57 one.
enum class Prestep { kNone, kHalf };

// A 16.16 coordinate (1/65536 texel) that is stepped, along an edge or along a span.
struct SourceWalk {
  int64_t at_fx16 = 0, step_fx16 = 0;

  // From a to b in `steps` steps > 0.
  SourceWalk() = default;
  SourceWalk(int64_t a_fx16, int64_t b_fx16, int64_t steps, Prestep prestep)
      : at_fx16(a_fx16), step_fx16(fixed_div(b_fx16 - a_fx16, steps)) {
    // Half a step is taken by a shift, which rounds down: half of a unit, in the last place only.
    if (prestep == Prestep::kHalf) at_fx16 += step_fx16 >> 1;
  }
  void advance(int64_t steps) { at_fx16 += step_fx16 * steps; }
};

// One of the two chains of edges from a polygon's top vertex to its bottom, stepped down row by
// row. The column is Bresenham's: whole steps and an error term, and exactly ceil(x).
class EdgeScan {
 public:
  enum class Direction { kLeft, kRight };  // backward, forward through the vertices
  EdgeScan(const mapper::Polygon& polygon, Direction direction, Prestep prestep);

  // Goes down to a row of the polygon, past any number of others: without a loop over them.
  void go_to(int32_t row);

  [[nodiscard]] int32_t column_px() const { return static_cast<int32_t>(column_px_); }
  [[nodiscard]] int64_t u_fx16() const { return u_.at_fx16; }
  [[nodiscard]] int64_t v_fx16() const { return v_.at_fx16; }

 private:
  void next_edge();
  void set_up(const selvage_vertex& from, const selvage_vertex& to);
  void advance(int64_t rows);

  const mapper::Polygon* polygon_;
  Direction direction_;
  Prestep prestep_;
  size_t end_vertex_;  // of the current edge
  int32_t row_ = 0;
  int32_t end_row_ = std::numeric_limits<int32_t>::min();  // the first row below the current edge

  int64_t column_px_ = 0, whole_step_px_ = 0, turn_px_ = 1;  // turn_px_: +1 rightward, -1 leftward
  int64_t error_ = 0, error_up_ = 0, error_down_ = 1;        // error_ in (-error_down_, 0]
  SourceWalk u_, v_;
};

}  // namespace selvage::historic
