// Bands: rows cut into strips of equal height that are drawn apart, and the index of which polygons
// reach which of them.
//
// The index is a binary tree over the bands. A polygon is listed at the fewest nodes whose bands
// together are those that it reaches: at one if it reaches one band, never at more than kMostNodes.
// The polygons of a band are the lists on the way from its leaf to the root, merged.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "many/runs.h"

namespace selvage::many {

inline constexpr size_t kMostBands = 64;  // a power of two
inline constexpr size_t kLevels = 7;      // of the tree: 1, 2, .. 64 nodes
inline constexpr size_t kMostNodes = 2 * (kLevels - 2);
static_assert(size_t{1} << (kLevels - 1) == kMostBands);

// Half-open.
struct Rows {
  int32_t first, end;

  [[nodiscard]] bool empty() const { return first >= end; }
  [[nodiscard]] int32_t count() const { return empty() ? 0 : end - first; }
  [[nodiscard]] Rows within(const Rows& other) const {
    return {std::max(first, other.first), std::min(end, other.end)};
  }
};

// Strips of 2^k rows, the last one maybe lower.
class Bands {
 public:
  // From `wanted` to twice as many, or fewer where they would be lower than `least_rows`. The rows
  // must not be empty; `wanted` lies in [1, kMostBands / 2].
  Bands(Rows rows, size_t wanted, int32_t least_rows);

  [[nodiscard]] size_t count() const { return count_; }
  [[nodiscard]] Rows rows(size_t band) const;
  // The band of a row, which must lie in the rows.
  [[nodiscard]] size_t band_of(int32_t row) const {
    return static_cast<size_t>((row - rows_.first) >> shift_);
  }

  // Calls take(node) for the nodes of the tree at which a polygon of these rows is listed.
  template <class Take>
  void for_each_node(Rows reach, const Take& take) const {
    const Rows seen = reach.within(rows_);
    if (seen.empty()) return;
    size_t first = kMostBands + band_of(seen.first), end = kMostBands + band_of(seen.end - 1) + 1;
    if (end - first == 1) return take(first);  // most often, and with nothing to be guessed wrong
    for (; first < end; first /= 2, end /= 2) {
      if (first % 2 != 0) take(first++);
      if (end % 2 != 0) take(--end);
    }
  }

 private:
  Rows rows_;
  int shift_ = 0;
  size_t count_ = 1;
};

// First add() what each polygon reaches, then end_adding(), then list() each, then read. Polygons
// come in runs: a run adds and lists in order, while others may do the same.
class BandIndex {
 public:
  // `entries` must hold kMostNodes a polygon, of which there are fewer than 2^32 / kMostNodes.
  BandIndex(const Bands& bands, std::span<uint32_t> entries) : bands_(bands), entries_(entries) {}

  void add(size_t run, Rows reach) {
    bands_.for_each_node(reach, [&](size_t node) { ++end_[node][run]; });
  }
  void end_adding();
  void list(size_t run, uint32_t polygon, Rows reach) {
    bands_.for_each_node(reach, [&](size_t node) { entries_[end_[node][run]++] = polygon; });
  }

  // The polygons of a band in their order.
  class Reader {
   public:
    Reader(const BandIndex& index, size_t band);
    // False if there is none left.
    [[nodiscard]] bool next(uint32_t* polygon);

   private:
    std::array<std::span<const uint32_t>, kLevels> lists_{};
    size_t count_ = 0;
  };

 private:
  // A node's list is that of its first run, then of its second, and so on; the lists of all nodes
  // lie one after another.
  using Ends = std::array<uint32_t, kMostRuns>;

  Bands bands_;
  std::span<uint32_t> entries_;
  std::array<Ends, 2 * kMostBands> end_{};  // of each part; how much of it is listed, until it is
};

}  // namespace selvage::many
