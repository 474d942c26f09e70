// What the measurement ran on and was built with.
#pragma once

#include <nlohmann/json.hpp>

namespace selvage::reports {

// CPU, cores, kernel, compiler, flags, versions of what is linked.
[[nodiscard]] nlohmann::ordered_json describe_machine();

}  // namespace selvage::reports
