// Numbers from text, whole or not at all: no blanks, no trailing characters, no other base.
#pragma once

#include <charconv>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace selvage::cli {

template <std::integral Integer>
[[nodiscard]] std::optional<Integer> parse_integer(std::string_view text) {
  Integer value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

// Finite numbers only.
[[nodiscard]] std::optional<double> parse_double(std::string_view text);

// Short and for people: 0.25, 1e+09.
[[nodiscard]] std::string show(double value);

// Three significant digits, and as many more as it takes to lie on the same side of the limit as
// the value does.
[[nodiscard]] std::string show_beside(double value, double limit);

// The parts between separators; n separators give n + 1 parts.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

}  // namespace selvage::cli
