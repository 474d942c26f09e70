#include "cli/text_columns.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "cli/number.h"

namespace selvage::cli {

std::string short_number(double value) {
  char text[32];
  const int digits = value > 0 ? 2 - static_cast<int>(std::floor(std::log10(value))) : 0;
  std::snprintf(text, sizeof text, "%.*f", std::clamp(digits, 0, 6), value);
  return value > 0 && value < 1e-6 ? show(value) : text;
}

std::string columns(std::span<const std::string> fields, std::span<const int> widths) {
  std::string line;
  for (size_t i = 0; i < fields.size(); ++i) {
    const auto width = static_cast<size_t>(std::abs(widths[i]));
    const std::string space(width - std::min(width, fields[i].size()), ' ');
    line += widths[i] < 0 ? fields[i] + space : space + fields[i];
  }
  return line + "\n";
}

std::string wrapped(std::string_view text, size_t indent) {
  std::string lines;
  size_t room = kTerminalColumns;
  while (text.size() > room) {
    const size_t space = text.rfind(' ', room);
    const size_t end = space == std::string_view::npos ? room : space;
    lines += std::string(text.substr(0, end)) + "\n" + std::string(indent, ' ');
    text.remove_prefix(std::min(end + 1, text.size()));
    room = kTerminalColumns - indent;
  }
  return lines + std::string(text) + "\n";
}

std::string list_entry(std::string_view name, std::string_view text, size_t indent) {
  std::string entry(name);
  entry += std::string(entry.size() < indent ? indent - entry.size() : 1, ' ');
  return wrapped(entry + std::string(text), indent);
}

}  // namespace selvage::cli
