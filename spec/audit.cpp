#include "spec/audit.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

#include "spec/exact.h"

namespace selvage::spec {
namespace {

// COV is due to judge the whole target, those of texels what is drawn of it; FILTER draws twice,
// once with one colour.
inline constexpr std::array<std::string_view, 3> kLaws = {"COV", "MAP", "FILTER"};
[[nodiscard]] bool judges_coverage(std::string_view law) { return law == "COV"; }
[[nodiscard]] uint64_t drawings(std::string_view law) { return law == "FILTER" ? 2 : 1; }

// From the definition: the two crossings of the row's centre line, and the centre between them.
[[nodiscard]] bool is_drawn(const Case& c, AuditedPixel p) {
  if (c.has_clip && (p.x_px < c.clip.left || p.x_px >= c.clip.right || p.y_px < c.clip.top ||
                     p.y_px >= c.clip.bottom)) {
    return false;
  }
  const std::optional<ScanLine> line = scan_line(c.vertices, p.y_px);
  const Rational centre(2 * p.x_px + 1, 2);
  return line && line->left.x <= centre && centre < line->right.x;
}

[[nodiscard]] std::vector<AuditedPixel> due_pixels(std::string_view law, const Case& c) {
  std::vector<AuditedPixel> due;
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    for (int32_t x = 0; x < c.target_width_px; ++x) {
      if (judges_coverage(law) || is_drawn(c, {x, y})) due.push_back({x, y});
    }
  }
  return due;
}

[[nodiscard]] size_t bytes_of(selvage_format format) {
  return format == SELVAGE_INDEX8 ? 1 : format == SELVAGE_RGB565 ? 2 : 4;
}

// What is wrong with a pixel.
enum class Spoiled { kNotDrawn, kDrawn, kOtherBits };

// Draws rightly, then spoils one pixel.
[[nodiscard]] Subject wrong_in(AuditedPixel at, Spoiled how) {
  Subject subject = built_in();
  subject.draw = [at, how](const selvage_image* target, const selvage_rect* clip,
                           const selvage_vertex* vertices, size_t count,
                           const selvage_texture* texture, const selvage_options* options) {
    if (at.x_px >= target->width || at.y_px >= target->height) {
      return selvage_draw(target, clip, vertices, count, texture, options);
    }
    const size_t size = bytes_of(target->format);
    auto* const pixel = static_cast<unsigned char*>(target->pixels) + at.y_px * target->pitch +
                        at.x_px * static_cast<ptrdiff_t>(size);
    std::array<unsigned char, 4> before{};
    std::memcpy(before.data(), pixel, size);
    const selvage_status status = selvage_draw(target, clip, vertices, count, texture, options);
    constexpr unsigned char kAnyByte = 0x3C;  // in no background of the laws' pictures
    for (size_t i = 0; i < size; ++i) {
      pixel[i] = how == Spoiled::kNotDrawn ? before[i]
                 : how == Spoiled::kDrawn  ? kAnyByte
                                           : static_cast<unsigned char>(~pixel[i]);
    }
    return status;
  };
  return subject;
}

[[nodiscard]] Spoiled spoiled(std::string_view law, const Case& c, AuditedPixel at) {
  if (!judges_coverage(law)) return Spoiled::kOtherBits;
  return is_drawn(c, at) ? Spoiled::kNotDrawn : Spoiled::kDrawn;
}

}  // namespace

std::span<const std::string_view> audited_laws() { return kLaws; }

Audit audit(std::string_view law, Judgement (*check)(const Subject&, const Case&), const Case& c) {
  const std::vector<AuditedPixel> due = due_pixels(law, c);
  const Judgement of_right = check(built_in(), c);
  Audit result{.due_px = drawings(law) * due.size(),
               .judged_px = of_right.judged_px,
               .rejects_right = of_right.violation.has_value()};
  for (const AuditedPixel at : due) {
    if (!check(wrong_in(at, spoiled(law, c, at)), c).violation) result.missed.push_back(at);
  }
  return result;
}

}  // namespace selvage::spec
