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
  ~StatusLine() { wipe(); }
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  void show(std::string_view text);
  void wipe();
  // The same, at most ten times a second, and "what 20 of 200".
  void show_now_and_then(std::string_view text);
  void count(std::string_view what, uint64_t done, uint64_t total);

 private:
  const Console& console_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_{};
};

}  // namespace selvage::cli
