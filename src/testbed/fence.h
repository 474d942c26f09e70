// Bytes right before and behind memory that somebody else writes to, where no guard page can be.
#pragma once

#include <cstddef>
#include <string>

#include "testbed/arena.h"

namespace selvage::testbed {

class Fence {
 public:
  // Fills what is within 64 bytes of `given` and in `room`, which holds it.
  Fence(const Range& room, const Range& given);

  // "wrote 3 bytes after the end of the " + name, where it is not as it was; empty if it is.
  [[nodiscard]] std::string fault(const std::string& name) const;

 private:
  Range before_, behind_;
};

}  // namespace selvage::testbed
