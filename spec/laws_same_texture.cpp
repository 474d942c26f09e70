// Law SAME, of textures: a texture shows the same as a part of a larger one. Those of cases are
// small; what overflows does so far from the first texel, or where rows are far apart.
#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "spec/canvas.h"
#include "spec/filter_texture.h"
#include "spec/law_list.h"
#include "spec/law_tools.h"
#include "spec/status_name.h"

namespace selvage::spec {
namespace {

// Where a case's texture lies in a larger one that goes on like it: addressed, both show the same
// everywhere, for the larger one's sides are multiples of its own.
struct Part {
  Case larger;
  Texel corner;
};

// So many times a side that it is at least as long, in powers of two.
[[nodiscard]] int32_t multiple_of(int32_t side_texel, int32_t least_texel) {
  const auto times = static_cast<uint32_t>((least_texel + side_texel - 1) / side_texel);
  return side_texel * static_cast<int32_t>(std::bit_ceil(times));
}

[[nodiscard]] bool shift(int32_t* coordinate, int32_t by_texel) {
  const int64_t shifted = *coordinate + int64_t{by_texel} * SELVAGE_SUBTEXELS;
  if (shifted != static_cast<int32_t>(shifted)) return false;
  *coordinate = static_cast<int32_t>(shifted);
  return true;
}

// Its far corner; empty where that is too far for the subject, or for 32 bits.
[[nodiscard]] std::optional<Part> far_part(const Subject& subject, const Case& c,
                                           Choices& choices) {
  constexpr std::array<Texel, 4> kLeast = {{{257, 257}, {700, 40}, {40, 700}, {9000, 3}}};
  constexpr int64_t kMostTexels = 1 << 19;
  const Texel least = kLeast[static_cast<size_t>(choices.pick(0, 4))];
  Part part{c, {}};
  int32_t& width = part.larger.texture_width_texel;
  int32_t& height = part.larger.texture_height_texel;
  part.corner = {multiple_of(width, least.s) - width, multiple_of(height, least.t) - height};
  width += part.corner.s;
  height += part.corner.t;
  const bool is_larger = part.corner.s > 0 || part.corner.t > 0;
  const bool fits = is_larger && std::max(width, height) <= subject.claims.longest_side_texel &&
                    int64_t{width} * height <= kMostTexels;
  if (!fits) return std::nullopt;
  for (selvage_vertex& v : part.larger.vertices) {
    if (!shift(&v.u, part.corner.s) || !shift(&v.v, part.corner.t)) return std::nullopt;
  }
  return part;
}

// Rows so far apart that 16 bits do not tell it; the target's, too.
[[nodiscard]] std::optional<Part> with_far_rows(const Case& c, Choices& choices) {
  constexpr int64_t kMostBytes = int64_t{2} << 20;
  const int64_t pitch_bytes = choices.pick(33000, 140000);
  if (pitch_bytes * std::max(c.texture_height_texel, c.target_height_px) > kMostBytes) {
    return std::nullopt;
  }
  Part part{c, {0, 0}};
  part.larger.layout = Layout::kGiven;
  part.larger.padding_px = static_cast<int32_t>(pitch_bytes / bytes_per_pixel(c.format));
  return part;
}

[[nodiscard]] std::string text_of(const Part& part) {
  const Case& larger = part.larger;
  if (part.corner == Texel{0, 0}) {
    return "a texture shows the same where rows are " +
           std::to_string((larger.texture_width_texel + larger.padding_px) *
                          bytes_per_pixel(larger.format)) +
           " bytes apart";
  }
  return "a texture shows the same at (" + std::to_string(part.corner.s) + ", " +
         std::to_string(part.corner.t) + ") of one of " +
         std::to_string(larger.texture_width_texel) + " x " +
         std::to_string(larger.texture_height_texel) + " texels";
}

}  // namespace

// Of some cases, for a large texture takes longer to fill than most of them to draw. Of the exact
// profile alone: others may round (u, v) otherwise elsewhere.
Judgement check_same_texture(const Subject& subject, const Case& c) {
  constexpr int32_t kLargerOneIn = 12;
  constexpr uint32_t kOwnChoices = 0xC2B2AE35;  // apart from those of the law's other parts
  Choices choices(c.choice ^ kOwnChoices);
  const int32_t kind = choices.pick(0, kLargerOneIn);
  if (kind > 1 || c.profile != SELVAGE_PROFILE_EXACT) return {};
  const auto part = kind == 0 ? with_far_rows(c, choices) : far_part(subject, c, choices);
  if (!part || beyond(subject.claims, part->larger)) return {};
  const TexelAt texel_at = filter_texture(c);
  const auto in_larger = [&](Texel texel) {
    return texel_at({address_texel(texel.s - part->corner.s, c.texture_width_texel, c.address),
                     address_texel(texel.t - part->corner.t, c.texture_height_texel, c.address)});
  };
  const Picture own = draw(subject, c, texel_at), other = draw(subject, part->larger, in_larger);
  if (other.status != own.status) {
    return {.violation =
                violation_of_call("SAME", text_of(*part), c, "status " + status_name(own.status),
                                  "status " + status_name(other.status))};
  }
  OtherDrawing by_itself = drawing_of(subject, "by itself it shows it");
  by_itself.shows_texels = false;
  return compare("SAME", text_of(*part), c, other, by_itself,
                 [&](int32_t x, int32_t y) { return must_be(own.at(x, y)); });
}

}  // namespace selvage::spec
