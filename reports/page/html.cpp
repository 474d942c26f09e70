#include "reports/page/html.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace selvage::reports {

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string grouped(uint64_t number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += "&nbsp;";
    text += digits[i];
  }
  return text;
}

std::string rounded(double value) {
  const double magnitude = value > 0 ? std::floor(std::log10(value)) : 0;
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", std::clamp(2 - static_cast<int>(magnitude), 0, 6),
                value);
  return text;
}

std::string element(std::string_view tag, std::string_view html, std::string_view attributes) {
  std::string text = "<" + std::string(tag);
  if (!attributes.empty()) text += " " + std::string(attributes);
  text += ">" + std::string(html) + "</" + std::string(tag) + ">";
  const bool within_a_line = tag == "strong" || tag == "code" || tag == "small" || tag == "span";
  return within_a_line ? text : text + "\n";
}

std::string number_cell(std::string_view html) { return element("td", html, "class=n"); }

}  // namespace selvage::reports
