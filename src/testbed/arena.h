// Memory that two processes share, between stretches that nobody may touch.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace selvage::testbed {

// Addresses [begin, end).
struct Range {
  uintptr_t begin = 0, end = 0;

  [[nodiscard]] size_t bytes() const { return end - begin; }
  [[nodiscard]] bool is_empty() const { return begin == end; }
  [[nodiscard]] bool holds(uintptr_t address) const { return begin <= address && address < end; }
  [[nodiscard]] bool holds(const Range& other) const {
    return begin <= other.begin && other.end <= end;
  }
  // They overlap, or one begins where the other ends.
  [[nodiscard]] bool touches(const Range& other) const {
    return begin <= other.end && other.begin <= end;
  }
};

inline constexpr size_t kGuardBytes = size_t{256} << 20;  // address space, no memory

// At the same addresses in this process and in those that it forks. Throws std::bad_alloc where
// there is no address space left.
class Arena {
 public:
  explicit Arena(size_t bytes);  // rounded up to whole pages
  ~Arena();
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  [[nodiscard]] Range range() const { return range_; }
  // With the guards on both sides.
  [[nodiscard]] Range guarded() const {
    return {range_.begin - kGuardBytes, range_.end + kGuardBytes};
  }
  // In this process alone.
  void make_read_only() const;
  void make_writable() const;

 private:
  Range range_;
};

// Fills a range from its end downward, or from its beginning upward.
class Packer {
 public:
  Packer(Range room, bool from_end) : room_(room), from_end_(from_end) {}

  [[nodiscard]] size_t bytes_left() const { return room_.bytes(); }
  // Where so many bytes go, at most those that are left: as near to what is taken already, or to
  // the range's end, as an address lets them that is `like` modulo `unit`, a power of two. Empty
  // where that is too many.
  [[nodiscard]] std::optional<uintptr_t> place(size_t bytes, uintptr_t like, size_t unit);

 private:
  Range room_;
  bool from_end_;
};

}  // namespace selvage::testbed
