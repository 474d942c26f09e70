#include "cli/number.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace selvage::cli {

std::optional<double> parse_double(std::string_view text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string show(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

std::string show_beside(double value, double limit) {
  constexpr int kFewest = 3, kMost = std::numeric_limits<double>::max_digits10;
  constexpr double kMostWritten = 1e10;  // without an exponent
  if (!std::isfinite(value)) return show(value);
  const double size = std::abs(value);
  const bool is_written = size >= 1 && size < kMostWritten;
  char text[32];
  for (int digits = kFewest; digits <= kMost; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (is_written && std::string_view(text).find('e') != std::string_view::npos) continue;
    const std::optional<double> shown = parse_double(text);
    if (shown && (*shown < limit) == (value < limit) && (*shown > limit) == (value > limit)) break;
  }
  return text;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const size_t stop = text.find(separator);
    parts.push_back(text.substr(0, stop));
    if (stop == std::string_view::npos) return parts;
    text.remove_prefix(stop + 1);
  }
}

}  // namespace selvage::cli
