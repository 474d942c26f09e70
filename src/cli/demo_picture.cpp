#include "cli/demo_picture.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "cli/bitmap_font.h"
#include "cli/profile_drawing.h"

namespace selvage::cli {
namespace {

inline constexpr Colour kTextColour{255, 236, 170};
inline constexpr int32_t kDifferenceGain = 4;

constexpr const char* kHelp[] = {"S / SHIFT-S  faster / slower",
                                 "X Y Z        turn about that axis",
                                 "SPACE        turn the other way",
                                 "ARROWS + -   move, nearer, farther",
                                 "F            next filter",
                                 "M            next mapper",
                                 "D            difference from exact",
                                 "P            print the frame rate",
                                 "H            this help",
                                 "ESC / Q      quit"};

// Puts the difference from `exact` into the picture and counts the pixels.
[[nodiscard]] int64_t show_difference(const Raster& exact, Raster& picture) {
  int64_t differing_px = 0;
  for (size_t i = 0; i < picture.rgba.size(); i += 4) {
    bool differs = false;
    for (size_t c = i; c < i + 3; ++c) {
      const int32_t difference = std::abs(picture.rgba[c] - exact.rgba[c]);
      differs = differs || difference != 0;
      picture.rgba[c] = static_cast<uint8_t>(std::min(255, kDifferenceGain * difference));
    }
    picture.rgba[i + 3] = 255;
    differing_px += differs;
  }
  return differing_px;
}

void draw_lines(Raster& picture, const std::vector<std::string>& lines, int32_t top_px,
                int32_t dot_px) {
  size_t longest = 0;
  for (const std::string& line : lines) longest = std::max(longest, line.size());
  const int32_t line_px = kGlyphHeight_dots * dot_px, left_px = 4 * dot_px;
  shade(picture, 0, top_px - dot_px,
        2 * left_px + static_cast<int32_t>(longest) * kGlyphWidth_dots * dot_px,
        static_cast<int32_t>(lines.size()) * line_px + 2 * dot_px);
  for (const std::string& line : lines) {
    draw_text(picture, left_px, top_px, dot_px, line, kTextColour);
    top_px += line_px;
  }
}

[[nodiscard]] std::vector<std::string> settings_lines(const DemoState& state,
                                                      const DemoPicture& picture) {
  std::vector<std::string> lines{demo_settings(state), demo_counts(state, picture)};
  if (state.mapper != SELVAGE_PROFILE_EXACT) {
    lines.insert(lines.begin() + 1, "drawn on whole pixels, no depth, nearest");
  }
  if (!state.help && !state.difference) lines.back() += " - H: help";
  return lines;
}

void draw_texts(const DemoState& state, DemoPicture& picture) {
  Raster& raster = picture.raster;
  const int32_t dot_px = std::max(1, std::min(raster.height_px, raster.width_px / 4 * 3) / 240);
  if (state.help) {
    draw_lines(raster, {std::begin(kHelp), std::end(kHelp)}, 4 * dot_px, dot_px);
  }
  const std::vector<std::string> lines = settings_lines(state, picture);
  const auto count = static_cast<int32_t>(lines.size());
  draw_lines(raster, lines, raster.height_px - (count * kGlyphHeight_dots + 2) * dot_px, dot_px);
}

}  // namespace

DemoPicture demo_picture(const scene::Scene& scene, const DemoState& state, scene::Size size) {
  const scene::Scene now = posed(scene, state);
  scene::Paints paints(now, scene::kLitBytes);
  return posed_picture(now, state, size, paints);
}

DemoPicture posed_picture(const scene::Scene& now, const DemoState& state, scene::Size size,
                          scene::Paints& paints) {
  const bool exact_mapper = state.mapper == SELVAGE_PROFILE_EXACT;
  scene::Wish wish{now.tolerance_texel, state.filter};
  ProfileDrawing drawn = draw_by_profile(now, state.time_s, size, wish, state.mapper, paints);
  DemoPicture picture{to_raster(std::move(drawn.picture)), drawn.faces, 0};
  if (state.difference) {
    wish.tolerance_texel = 0;
    if (!exact_mapper) wish.filter = SELVAGE_FILTER_NEAREST;
    const Raster exact = to_raster(
        draw_by_profile(now, state.time_s, size, wish, SELVAGE_PROFILE_EXACT, paints).picture);
    picture.differing_px = show_difference(exact, picture.raster);
  }
  draw_texts(state, picture);
  return picture;
}

std::string demo_counts(const DemoState& state, const DemoPicture& picture) {
  std::string text = std::to_string(picture.faces) + " faces";
  if (state.difference) text += ", " + std::to_string(picture.differing_px) + " px differ";
  return text;
}

}  // namespace selvage::cli
