#include "many/bands.h"

#include <algorithm>

namespace selvage::many {

Bands::Bands(Rows rows, size_t wanted, int32_t least_rows) : rows_(rows) {
  const auto height = static_cast<size_t>(rows.count());
  const auto least = static_cast<size_t>(least_rows);
  while (size_t{2} << shift_ <= height / wanted || size_t{1} << shift_ < least) ++shift_;
  count_ = (height + (size_t{1} << shift_) - 1) >> shift_;
}

Rows Bands::rows(size_t band) const {
  const auto first = static_cast<int32_t>(band << shift_);
  return {rows_.first + first,
          rows_.first + static_cast<int32_t>(std::min<int64_t>(
                            int64_t{first} + (int64_t{1} << shift_), rows_.count()))};
}

void BandIndex::end_adding() {
  uint32_t total = 0;
  for (Ends& of_runs : end_) {
    for (uint32_t& end : of_runs) {
      const uint32_t listed = end;
      end = total;
      total += listed;
    }
  }
}

// Node 0 does not exist and lists nothing.
BandIndex::Reader::Reader(const BandIndex& index, size_t band) {
  for (size_t node = kMostBands + band; node > 0; node /= 2) {
    const uint32_t first = index.end_[node - 1].back(), end = index.end_[node].back();
    if (first != end) lists_[count_++] = index.entries_.subspan(first, end - first);
  }
}

bool BandIndex::Reader::next(uint32_t* polygon) {
  if (count_ == 0) return false;
  size_t least = 0;
  for (size_t i = 1; i < count_; ++i) {
    if (lists_[i].front() < lists_[least].front()) least = i;
  }
  *polygon = lists_[least].front();
  lists_[least] = lists_[least].subspan(1);
  if (lists_[least].empty()) lists_[least] = lists_[--count_];
  return true;
}

}  // namespace selvage::many
