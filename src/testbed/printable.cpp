#include "testbed/printable.h"

#include <cstdint>

namespace selvage::testbed {
namespace {

// What a first byte tells (RFC 3629): the character's bytes and the least code that needs them all.
struct Form {
  size_t bytes;
  uint32_t bits, least;
};

[[nodiscard]] Form form_of(uint32_t first) {
  if (first < 0x80) return {1, first, 0};
  if (first >= 0xC0 && first < 0xE0) return {2, first & 0x1F, 0x80};
  if (first >= 0xE0 && first < 0xF0) return {3, first & 0x0F, 0x800};
  if (first >= 0xF0 && first < 0xF8) return {4, first & 0x07, 0x10000};
  return {0, 0, 0};
}

[[nodiscard]] bool may_be_shown(uint32_t code) {
  const bool is_control = code < 0x20 || (code >= 0x7F && code < 0xA0);
  return !is_control && code != 0xFFFE && code != 0xFFFF;
}

}  // namespace

FirstCharacter first_character(std::string_view text) {
  const auto byte = [&](size_t i) { return uint32_t{static_cast<unsigned char>(text[i])}; };
  if (text.empty()) return {};
  const Form form = form_of(byte(0));
  if (form.bytes == 0 || form.bytes > text.size()) return {1, false};
  uint32_t code = form.bits;
  for (size_t i = 1; i < form.bytes; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {1, false};
    code = code << 6 | (byte(i) & 0x3F);
  }
  const bool is_surrogate = code >= 0xD800 && code < 0xE000;
  if (code < form.least || code > 0x10FFFF || is_surrogate) return {1, false};
  return {form.bytes, may_be_shown(code)};
}

std::string printable(std::string_view text, size_t most_bytes) {
  std::string shown;
  while (!text.empty()) {
    const auto [bytes, is_printable] = first_character(text);
    const std::string_view next = is_printable ? text.substr(0, bytes) : kReplacement;
    if (next.size() > most_bytes - shown.size()) break;
    shown += next;
    text.remove_prefix(bytes);
  }
  return shown;
}

}  // namespace selvage::testbed
