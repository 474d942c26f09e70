// Where a command talks to, and what its exit code means.
#pragma once

#include <ostream>

namespace selvage::cli {

inline constexpr int kExitFine = 0;
inline constexpr int kExitLawFailed = 1;
inline constexpr int kExitUsage = 2;   // wrong use, or a file that cannot be read or written
inline constexpr int kExitNoTime = 3;  // nothing was found wrong, but not all could be judged

struct Console {
  std::ostream& out;
  std::ostream& err;
  bool show_progress = false;    // err is a terminal
  bool out_is_terminal = false;  // which shows no pictures
};

}  // namespace selvage::cli
