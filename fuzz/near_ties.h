// What a case costs beyond its pixels: its near-ties, counted by the lanes that the mapper draws
// with, and the rows and pieces that are set up for them.
#pragma once

#include <cstdint>

#include "spec/case.h"

namespace selvage::fuzz {

enum class MapKind { kPlane, kRuledAffine, kSameDepthAlongRows, kInDepth, kRuledInDepth };
inline constexpr int kMapKinds = 5;
inline constexpr int32_t kRun_px = 16;

struct NearTies {
  MapKind kind = MapKind::kPlane;
  int64_t coordinates = 0;  // two for each pixel drawn
  int64_t near = 0;         // those that the exact map must decide
  // Of kRun_px pixels of a row, as many as a vector holds, or the last ones: all, and those with a
  // coordinate that the exact map must decide. A single one makes them cost more.
  int64_t runs = 0, near_runs = 0;
  // The first thing that breaks a bound; nullptr if nothing does.
  const char* fault = nullptr;
};

// Of a case of the exact profile, by nearest or a filter over four texels; all 0 where nothing is
// drawn, or copied. Bounds, each derived in src/mapper:
//   one decision is enough   the exact floor is the lane's or the next one
//   none is in vain          it is asked for only within kMostDoubt of a whole number
//   few pieces               a row has at most kMostPieces, each with an exact row of its own
[[nodiscard]] NearTies count_near_ties(const spec::Case& c);

// In units of the whole numbers: texels, or steps of the filters' grid.
inline constexpr double kMostDoubt_texel = 0x1p-13;
inline constexpr double kMostDoubt_grid = 0x1p-6;

}  // namespace selvage::fuzz
