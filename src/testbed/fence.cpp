#include "testbed/fence.h"

#include <algorithm>
#include <cstring>

namespace selvage::testbed {
namespace {

inline constexpr size_t kBytes = 64;
inline constexpr uint8_t kFilling = 0xC3;

void fill(const Range& range) {
  if (!range.is_empty()) std::memset(reinterpret_cast<void*>(range.begin), kFilling, range.bytes());
}

[[nodiscard]] bool is_as_filled(uintptr_t address) {
  return *reinterpret_cast<const volatile uint8_t*>(address) == kFilling;
}

[[nodiscard]] std::string bytes(uintptr_t count) {
  return std::to_string(count) + (count == 1 ? " byte" : " bytes");
}

}  // namespace

Fence::Fence(const Range& room, const Range& given)
    : before_{given.begin - std::min(kBytes, given.begin - room.begin), given.begin},
      behind_{given.end, given.end + std::min(kBytes, room.end - given.end)} {
  fill(before_);
  fill(behind_);
}

std::string Fence::fault(const std::string& name) const {
  for (uintptr_t at = behind_.begin; at < behind_.end; ++at) {
    if (is_as_filled(at)) continue;
    return at == behind_.begin
               ? "wrote just after the end of the " + name
               : "wrote " + bytes(at - behind_.begin) + " after the end of the " + name;
  }
  for (uintptr_t at = before_.end; at-- > before_.begin;) {
    if (is_as_filled(at)) continue;
    return "wrote " + bytes(before_.end - at) + " before the start of the " + name;
  }
  return {};
}

}  // namespace selvage::testbed
