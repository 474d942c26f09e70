// Boxes of neighbouring pixels, on their way from stage to stage of the area filter.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "mapper/filter_box.h"
#include "mapper/filter_point.h"
#include "mapper/footprint.h"
#include "mapper/span.h"

namespace selvage::mapper {

// So many pixels go through the stages at a time: their boxes stay in the nearest cache.
inline constexpr int32_t kBoxPiece_px = 128;
inline constexpr int32_t kBoxPieceSpare_px = 16;  // for a vector that begins in the last pixel

struct BoxRow {
  using Numbers = std::array<int32_t, kBoxPiece_px + kBoxPieceSpare_px>;
  Numbers u_fx8, v_fx8;           // points
  Numbers width_fx8, height_fx8;  // sides

  [[nodiscard]] Box box(int32_t i) const {
    const auto at = static_cast<size_t>(i);
    return Box::around({u_fx8[at], v_fx8[at]}, {width_fx8[at], height_fx8[at]});
  }
  void set(int32_t i, FilterPoint point, BoxSides sides) {
    u_fx8[static_cast<size_t>(i)] = point.u_fx8;
    v_fx8[static_cast<size_t>(i)] = point.v_fx8;
    set_sides(i, sides);
  }
  void set_sides(int32_t i, BoxSides sides) {
    width_fx8[static_cast<size_t>(i)] = sides.u_fx8;
    height_fx8[static_cast<size_t>(i)] = sides.v_fx8;
  }
};

// Calls visit(piece) for the pieces of a span, from the left.
template <class Visit>
inline void for_each_box_piece(const Span& span, const Visit& visit) {
  for (int32_t px = span.left_px; px < span.right_px; px += kBoxPiece_px) {
    const int32_t end_px = px + kBoxPiece_px < span.right_px ? px + kBoxPiece_px : span.right_px;
    visit(Span{span.row, px, end_px});
  }
}

}  // namespace selvage::mapper
