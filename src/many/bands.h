// Bands: rows cut into strips of equal height.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace selvage::many {

inline constexpr size_t kMostBands = 128;
inline constexpr int kLeastBandBits = 3;
inline constexpr int32_t kLeastBandRows = 1 << kLeastBandBits;

// Half-open.
struct Rows {
  int32_t first, end;

  [[nodiscard]] bool empty() const { return first >= end; }
  [[nodiscard]] int32_t count() const { return empty() ? 0 : end - first; }
  [[nodiscard]] Rows within(const Rows& other) const {
    return {std::max(first, other.first), std::min(end, other.end)};
  }
};

// Numbers of bands, half-open.
struct BandRange {
  size_t first, end;

  [[nodiscard]] size_t count() const { return end - first; }
  // Without bands where they have none in common.
  [[nodiscard]] BandRange within(const BandRange& other) const {
    const size_t from = std::max(first, other.first);
    return {from, std::max(from, std::min(end, other.end))};
  }
};

// Strips of 2^k rows, kLeastBandRows or more, the last one maybe lower: as many as can be, up to
// kMostBands.
class Bands {
 public:
  explicit Bands(Rows rows) : rows_(rows) {
    while ((kMostBands << shift_) < static_cast<size_t>(rows.count())) ++shift_;
  }

  [[nodiscard]] size_t count() const { return reached_by(rows_).end; }
  // Of each but the last.
  [[nodiscard]] int32_t height() const { return int32_t{1} << shift_; }
  // Those with one of these rows in them.
  [[nodiscard]] BandRange reached_by(Rows rows) const {
    const Rows seen = rows.within(rows_);
    return seen.empty() ? BandRange{0, 0} : BandRange{of(seen.first), of(seen.end - 1) + 1};
  }
  [[nodiscard]] Rows rows(BandRange bands) const {
    return Rows{first_row(bands.first), first_row(bands.end)}.within(rows_);
  }

 private:
  [[nodiscard]] size_t of(int32_t row) const {
    return static_cast<size_t>(row - rows_.first) >> shift_;
  }
  [[nodiscard]] int32_t first_row(size_t band) const {
    const int64_t row = rows_.first + (static_cast<int64_t>(band) << shift_);
    return static_cast<int32_t>(std::min<int64_t>(row, rows_.end));
  }

  Rows rows_;
  int shift_ = kLeastBandBits;
};

}  // namespace selvage::many
