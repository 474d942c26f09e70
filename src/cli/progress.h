// One line that counts, for a person who waits. Writes nothing where progress is not shown.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "cli/console.h"

namespace selvage::cli {

class Progress {
 public:
  Progress(const Console& console, std::string what, uint64_t total);
  ~Progress();  // wipes the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(uint64_t done);

 private:
  const Console& console_;
  std::string what_;
  uint64_t total_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_{};
};

}  // namespace selvage::cli
