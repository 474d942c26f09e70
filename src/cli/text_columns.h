// Text in columns, for tables on a terminal.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace selvage::cli {

inline constexpr size_t kTerminalColumns = 100;

// Three significant digits, and 0 for nothing but 0.
[[nodiscard]] std::string short_number(double value);

// The fields at their widths, negative ones to the left, and an end of line.
[[nodiscard]] std::string columns(std::span<const std::string> fields, std::span<const int> widths);

// Whole words on lines of kTerminalColumns, all but the first indented.
[[nodiscard]] std::string wrapped(std::string_view text, size_t indent = 0);

// A name, then its text in a column of its own.
[[nodiscard]] std::string list_entry(std::string_view name, std::string_view text,
                                     size_t indent = 24);

}  // namespace selvage::cli
