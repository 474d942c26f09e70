// Where the arguments of one call lie: in the caller's memory, and in the arenas that the subject
// sees. Target and texture end at a guard, or begin at one.
#pragma once

#include <cstddef>
#include <string>

#include "testbed/arena.h"
#include "testbed/control.h"

namespace selvage::testbed {

// The memory that the subject is given, apart from the control block.
struct Arenas {
  Arena target{size_t{16} << 20};
  Arena texture{size_t{16} << 20};  // read-only to the subject, as those below
  Arena vertices{size_t{1} << 20};
  Arena structures{4096};
};

// Bytes of the caller's and where they are copied to.
struct Placed {
  Range from;  // empty: an argument so bad that nothing of it can be copied
  uintptr_t at = 0;

  [[nodiscard]] Range range() const { return {at, at + from.bytes()}; }
  [[nodiscard]] uintptr_t moved(const void* pointer) const {
    return at + (reinterpret_cast<uintptr_t>(pointer) - from.begin);
  }
};

class Placement {
 public:
  // Plans the call; its pointers are the caller's.
  Placement(const Arenas& arenas, const Call& call, bool at_end);

  // Copies what is the caller's in, and gives the call as the subject sees it.
  [[nodiscard]] Call copy_in() const;
  // Copies the target back, with what lies between its rows.
  void copy_out() const;

  // "just after the end of the target, where pixel (8, 5) would be"; empty if it is near nothing
  // that was given.
  [[nodiscard]] std::string place_of(uintptr_t address) const;

 private:
  const Arenas& arenas_;
  Call call_;
  Placed target_, texture_, vertices_;
};

}  // namespace selvage::testbed
