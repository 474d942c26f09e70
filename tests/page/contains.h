// What a text says, for tests of it.
#pragma once

#include <string>

namespace selvage::reports {

[[nodiscard]] inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace selvage::reports
