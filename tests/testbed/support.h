// What the tests of the testbed share: the subjects that are built beside them.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>

#include "testbed/host.h"

namespace selvage::testbed::test {

inline constexpr std::chrono::milliseconds kPatience{20'000};  // machines may be busy

[[nodiscard]] inline std::filesystem::path library(const std::string& name) {
  return std::filesystem::path(SELVAGE_SUBJECTS) / (name + ".so");
}

[[nodiscard]] inline std::shared_ptr<Host> host_of(const std::string& name,
                                                   std::chrono::nanoseconds limit = kPatience) {
  return std::make_shared<Host>(library(name), limit);
}

}  // namespace selvage::testbed::test
