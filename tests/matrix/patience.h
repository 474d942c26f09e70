// How long a peer may take for one drawing before the tests call it hung.
#pragma once

#include <chrono>

namespace selvage::testbed {

inline constexpr std::chrono::seconds kPatience{20};

}  // namespace selvage::testbed
