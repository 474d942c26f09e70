// Small pieces of HTML.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace selvage::reports {

// Text with &, <, > and quotes as entities.
[[nodiscard]] std::string escaped(std::string_view text);

// "1 234 567", with no-break spaces.
[[nodiscard]] std::string grouped(uint64_t number);

// Three significant digits: "0.198", "1.08", "16.3", "336".
[[nodiscard]] std::string rounded(double value);

// An element; a line of its own unless the tag is one of those within a line of text.
[[nodiscard]] std::string element(std::string_view tag, std::string_view html,
                                  std::string_view attributes = {});

// Of a table, its text to the right as numbers stand.
[[nodiscard]] std::string number_cell(std::string_view html);

}  // namespace selvage::reports
