// Steep spans in perspective, cut into pieces along which the denominator hardly grows.
//
// A lane's margin is in proportion to the ratio of the denominators at its span's ends. A ratio of
// 2^24 would leave every point of the filters' grid to the exact map; pieces keep margins so small
// that only coordinates which do lie next to a boundary are left to it.
#pragma once

#include <algorithm>
#include <cstdint>

#include "mapper/span.h"

namespace selvage::mapper {

inline constexpr int32_t kGentleRatio = 1024;

// D is linear and positive, so D(b) / D(a) <= b / a at the offsets a < b from the span's lesser
// end: pieces [0, 1), [1, k + 1), [k + 1, k (k + 1) + 1) .. with k = kGentleRatio have no greater
// ratio.
inline constexpr int32_t kMostPieces = 3;
static_assert(int64_t{kGentleRatio} * (kGentleRatio + 1) + 1 >
                  (1 << (kPositionBits - kSubpixelBits)),
              "they hold the longest span");

// Calls visit(piece) for each; `grows` tells that the denominator is less at the left end.
template <class Visit>
void for_each_gentle_piece(const Span& span, bool grows, const Visit& visit) {
  const int32_t width_px = span.width_px();
  for (int32_t first = 0, end = 1; first < width_px; first = end, end = first * kGentleRatio + 1) {
    end = std::min(end, width_px);
    visit(grows ? Span{span.row, span.left_px + first, span.left_px + end}
                : Span{span.row, span.right_px - end, span.right_px - first});
  }
}

}  // namespace selvage::mapper
