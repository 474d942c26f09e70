// What a measurement ran on, and what it was built with.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace selvage::reports {

// The texts of /proc/cpuinfo, /proc/meminfo and /etc/os-release; empty where there is none.
struct SystemTexts {
  std::string cpuinfo, meminfo, os_release;
};

// Names and values, in the order of the page.
using Machine = std::vector<std::pair<std::string, std::string>>;
[[nodiscard]] Machine describe_machine(const SystemTexts& texts);

}  // namespace selvage::reports
