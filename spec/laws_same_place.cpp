// Law SAME, of places: a drawing is the same wherever its target lies in a larger bitmap, and
// wherever in a larger target it is. Cases are small; what overflows does so far from the first
// pixel, or where rows are far apart.
#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "spec/canvas.h"
#include "spec/filter_texture.h"
#include "spec/law_list.h"
#include "spec/law_tools.h"
#include "spec/status_name.h"
#include "spec/texture_memory.h"

namespace selvage::spec {
namespace {

constexpr uint8_t kBackground = 0x5A;

// A case's target, in a larger one.
struct Place {
  int32_t width_px, height_px, padding_px;
  Pixel corner;  // where the case's target begins
};

class Placed {
 public:
  Placed(const Subject& subject, const Case& c)
      : subject_(subject), case_(c), texture_(subject, c, filter_texture(c), 0xEE) {}

  [[nodiscard]] bool is_prepared() const { return texture_.status() == SELVAGE_OK; }

  struct Drawn {
    Canvas canvas;
    selvage_status status = SELVAGE_OK;
  };
  [[nodiscard]] Drawn draw(const Place& place, const std::vector<selvage_vertex>& vertices) const {
    Drawn drawn{Canvas(case_.format, place.width_px, place.height_px, place.padding_px,
                       case_.flip_target, kBackground)};
    const selvage_image image = drawn.canvas.image();
    const selvage_options options{case_.profile, case_.filter, case_.address, 0,
                                  SELVAGE_KERNEL_FASTEST};
    const selvage_rect clip = clip_at(place.corner);
    drawn.status = with_shown(case_, [&] {
      return subject_.draw(&image, subject_.claims.clip ? &clip : nullptr, vertices.data(),
                           vertices.size(), &texture_.view(), &options);
    });
    return drawn;
  }

 private:
  // As much of the larger target as the case's own shows.
  [[nodiscard]] selvage_rect clip_at(Pixel corner) const {
    selvage_rect seen{0, 0, case_.target_width_px, case_.target_height_px};
    if (case_.has_clip) {
      seen = {std::max(seen.left, case_.clip.left), std::max(seen.top, case_.clip.top),
              std::min(seen.right, case_.clip.right), std::min(seen.bottom, case_.clip.bottom)};
    }
    return {seen.left + corner.x_px, seen.top + corner.y_px, seen.right + corner.x_px,
            seen.bottom + corner.y_px};
  }

  const Subject& subject_;
  const Case& case_;
  TextureMemory texture_;
};

[[nodiscard]] Place own_place(const Case& c) {
  return {c.target_width_px, c.target_height_px, c.padding_px, {0, 0}};
}

// Rows so far apart that 16 bits do not tell it, where these are not too many bytes.
[[nodiscard]] std::optional<Place> far_apart(const Case& c, Choices& choices) {
  constexpr int64_t kMostBytes = int64_t{4} << 20;
  const int64_t pitch_bytes = choices.pick(33000, 140000);
  if (pitch_bytes * c.target_height_px > kMostBytes) return std::nullopt;
  Place place = own_place(c);
  place.padding_px = static_cast<int32_t>(pitch_bytes / bytes_per_pixel(c.format));
  return place;
}

// In the far corner of a small screen, or of a long strip: of more than 2^16 pixels, and hardly
// more, for all of them are looked at.
[[nodiscard]] std::optional<Place> far_corner(const Subject& subject, const Case& c,
                                              Choices& choices) {
  constexpr std::array<Pixel, 4> kSizes = {{{320, 240}, {1024, 72}, {5000, 14}, {14, 5000}}};
  const Pixel size = kSizes[static_cast<size_t>(choices.pick(0, 4))];
  const int32_t longest = subject.claims.longest_side_px;
  Place place{std::max(size.x_px, c.target_width_px),
              std::max(size.y_px, c.target_height_px),
              c.padding_px,
              {}};
  constexpr int64_t kMostPixels = 1 << 20;
  const bool fits = place.width_px <= longest && place.height_px <= longest &&
                    int64_t{place.width_px} * place.height_px <= kMostPixels;
  if (!fits || !subject.claims.clip) return std::nullopt;
  place.corner = {place.width_px - c.target_width_px, place.height_px - c.target_height_px};
  return place;
}

[[nodiscard]] std::string text_of(const Place& place, const Case& c) {
  const auto size = std::to_string(place.width_px) + " x " + std::to_string(place.height_px);
  if (place.corner.x_px == 0 && place.corner.y_px == 0) {
    return "a drawing is the same where rows are " +
           std::to_string((place.width_px + place.padding_px) * bytes_per_pixel(c.format)) +
           " bytes apart";
  }
  return "a drawing is the same at (" + std::to_string(place.corner.x_px) + ", " +
         std::to_string(place.corner.y_px) + ") of a target of " + size + " px";
}

// The pixels of the case's own target as they are there, and no others.
[[nodiscard]] Judgement judge(const Subject& subject, const Case& c, const Place& place,
                              const Placed::Drawn& own, const Placed::Drawn& other) {
  const std::string what = text_of(place, c);
  Judgement judgement;
  const auto blame = [&](std::string allowed, std::string drawn) {
    judgement.violation = violation_of_call("SAME", what, c, std::move(allowed), std::move(drawn));
    return judgement;
  };
  if (other.status != own.status) {
    return blame("status " + status_name(own.status), "status " + status_name(other.status));
  }
  if (!other.canvas.guards_are_intact()) {
    return blame("the bytes beside the pixels as they were", "others");
  }
  const uint32_t background = Canvas(c.format, 1, 1, 0, false, kBackground).pixel(0, 0);
  for (int32_t y = 0; y < place.height_px; ++y) {
    for (int32_t x = 0; x < place.width_px; ++x) {
      ++judgement.judged_px;
      const int32_t own_x = x - place.corner.x_px, own_y = y - place.corner.y_px;
      const bool is_own =
          own_x >= 0 && own_y >= 0 && own_x < c.target_width_px && own_y < c.target_height_px;
      const uint32_t wanted = is_own ? own.canvas.pixel(own_x, own_y) : background;
      const uint32_t drawn = other.canvas.pixel(x, y);
      if (drawn == wanted) continue;
      if (is_own && is_in_doubt(subject.claims.coverage_accuracy_fx16, c, {own_x, own_y})) continue;
      const auto told = [&](uint32_t value) {
        return "value " + std::to_string(value) + " at (" + std::to_string(x) + ", " +
               std::to_string(y) + ")";
      };
      return blame(told(wanted), told(drawn));
    }
  }
  return judgement;
}

}  // namespace

// Of some cases, for a large target takes longer than most of them do.
Judgement check_same_place(const Subject& subject, const Case& c) {
  constexpr int32_t kElsewhereOneIn = 8;
  constexpr uint32_t kOwnChoices = 0x85EBCA6B;  // apart from those of the law's other parts
  Choices choices(c.choice ^ kOwnChoices);
  const int32_t kind = choices.pick(0, kElsewhereOneIn);
  if (kind > 1) return {};
  const auto place = kind == 0 ? far_apart(c, choices) : far_corner(subject, c, choices);
  if (!place) return {};
  const auto vertices = moved(c.vertices, int64_t{place->corner.x_px} * SELVAGE_SUBPIXELS,
                              int64_t{place->corner.y_px} * SELVAGE_SUBPIXELS);
  const Placed placed(subject, c);
  if (!vertices || !placed.is_prepared()) return {};
  return judge(subject, c, *place, placed.draw(own_place(c), c.vertices),
               placed.draw(*place, *vertices));
}

}  // namespace selvage::spec
