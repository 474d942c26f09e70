#include "cli/status_line.h"

#include <string>

namespace selvage::cli {

// "\r\x1b[K": to the beginning of the line, and clear it (ECMA-48).
void StatusLine::wipe() {
  if (shown_) console_.err << "\r\x1b[K" << std::flush;
  shown_ = false;
}

void StatusLine::show(std::string_view text) {
  if (!console_.show_progress) return;
  shown_ = true;
  console_.err << "\r\x1b[K" << text << std::flush;
}

void StatusLine::show_now_and_then(std::string_view text) {
  const auto now = std::chrono::steady_clock::now();
  if (!console_.show_progress || now < next_) return;
  next_ = now + std::chrono::milliseconds(100);
  show(text);
}

void StatusLine::count(std::string_view what, uint64_t done, uint64_t total) {
  show_now_and_then(std::string(what) + " " + std::to_string(done) + " of " +
                    std::to_string(total));
}

}  // namespace selvage::cli
