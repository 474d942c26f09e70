#include "cli/progress.h"

#include <utility>

namespace selvage::cli {

Progress::Progress(const Console& console, std::string what, uint64_t total)
    : console_(console), what_(std::move(what)), total_(total) {}

Progress::~Progress() {
  if (shown_) console_.err << "\r\x1b[K" << std::flush;
}

void Progress::update(uint64_t done) {
  const auto now = std::chrono::steady_clock::now();
  if (!console_.show_progress || now < next_) return;
  next_ = now + std::chrono::milliseconds(100);
  shown_ = true;
  console_.err << "\r\x1b[K" << what_ << ' ' << done << " of " << total_ << std::flush;
}

}  // namespace selvage::cli
