// Text of unknown origin, made fit for a terminal, for JSON and for XML.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace selvage::testbed {

inline constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD, in UTF-8

// How many bytes the first character of a text has, and whether it may be shown: it is valid UTF-8,
// no control character, and none that XML 1.0 cannot hold. Of what is invalid it is one byte.
struct FirstCharacter {
  size_t bytes = 0;
  bool is_printable = false;
};
[[nodiscard]] FirstCharacter first_character(std::string_view text);

// With U+FFFD for each character that may not be shown, ended where a character ends.
[[nodiscard]] std::string printable(std::string_view text,
                                    size_t most_bytes = std::string_view::npos);

}  // namespace selvage::testbed
