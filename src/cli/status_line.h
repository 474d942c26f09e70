// One line for a person who waits. Writes nothing where progress is not shown.
#pragma once

#include <chrono>
#include <cstdint>
#include <string_view>

#include "cli/console.h"

namespace selvage::cli {

class StatusLine {
 public:
  explicit StatusLine(const Console& console) : console_(console) {}
  ~StatusLine();  // wipes the line
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  void show(std::string_view text);
  // "what 20 of 200", at most ten times a second.
  void count(std::string_view what, uint64_t done, uint64_t total);

 private:
  const Console& console_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_{};
};

}  // namespace selvage::cli
