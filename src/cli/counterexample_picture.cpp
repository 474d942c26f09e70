#include "cli/counterexample_picture.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "spec/picture.h"

namespace selvage::cli {
namespace {

constexpr int32_t kWindowPx = 96;  // the most of a target that is shown, a side
constexpr int32_t kPanelPx = 384;  // about the side of a panel
constexpr int32_t kMaxScale = 32;  // px of the picture for one of the target
constexpr int32_t kGapPx = 8;
constexpr Colour kGap{24, 24, 24};
constexpr Colour kUnknown{255, 0, 255};
constexpr Colour kDiffers{255, 0, 0};
constexpr Colour kFrame{255, 255, 255};

using Pixel = std::optional<uint32_t>;

// The colours of the coordinate texture's texels.
class Palette {
 public:
  explicit Palette(const spec::Case& c) {
    const int32_t width = c.texture_width_texel;
    const int32_t height = c.texture_height_texel;
    for (int32_t t = 0; t < height; ++t) {
      for (int32_t s = 0; s < width; ++s) {
        const auto ramp = [](int32_t at, int32_t size) {
          return static_cast<uint8_t>(size > 1 ? 40 + 215 * int64_t{at} / (size - 1) : 147);
        };
        const uint8_t blue = (s + t) % 2 == 0 ? 120 : 40;  // so that neighbours differ
        colours_.try_emplace(spec::coordinate_texel(c.format, s, t),
                             Colour{ramp(s, width), ramp(t, height), blue});
      }
    }
  }

  [[nodiscard]] Colour of(const Pixel& pixel, int32_t x_px, int32_t y_px) const {
    if (!pixel) {
      const uint8_t grey = (x_px + y_px) % 2 == 0 ? 96 : 128;
      return {grey, grey, grey};
    }
    const auto found = colours_.find(*pixel);
    return found == colours_.end() ? kUnknown : found->second;
  }

 private:
  std::unordered_map<uint32_t, Colour> colours_;
};

// The part of the target that is shown, and how large.
struct View {
  int32_t left_px, top_px, width_px, height_px;
  int32_t scale;
};

[[nodiscard]] int32_t window_start(int32_t centre_px, int32_t window_px, int32_t size_px) {
  return std::clamp(centre_px - window_px / 2, 0, size_px - window_px);
}

[[nodiscard]] View view_around(const spec::Picture& picture, int32_t x_px, int32_t y_px) {
  const int32_t width = std::min(picture.width_px, kWindowPx);
  const int32_t height = std::min(picture.height_px, kWindowPx);
  return {window_start(x_px, width, picture.width_px),
          window_start(y_px, height, picture.height_px), width, height,
          std::clamp(kPanelPx / std::max(width, height), 1, kMaxScale)};
}

struct Point {
  int32_t x_px, y_px;
};

// The pixel to show: the blamed one, or the first that differs, or the first of all.
[[nodiscard]] Point focus(const spec::Violation& violation, const spec::Picture& drawn,
                          const spec::Picture& expected) {
  const bool blamed = violation.x_px >= 0 && violation.x_px < drawn.width_px &&
                      violation.y_px >= 0 && violation.y_px < drawn.height_px;
  if (blamed) return {violation.x_px, violation.y_px};
  const auto differs = std::mismatch(drawn.pixels.begin(), drawn.pixels.end(),
                                     expected.pixels.begin(), expected.pixels.end());
  if (differs.first == drawn.pixels.end()) return {0, 0};
  const auto index = static_cast<int32_t>(differs.first - drawn.pixels.begin());
  return {index % drawn.width_px, index / drawn.width_px};
}

[[nodiscard]] Colour dim(const Colour& colour) {
  const auto quarter = [](uint8_t channel) { return static_cast<uint8_t>(channel / 4); };
  return {quarter(colour.red), quarter(colour.green), quarter(colour.blue)};
}

void fill(Raster& raster, int32_t left_px, int32_t top_px, int32_t side_px, const Colour& colour) {
  for (int32_t y = top_px; y < top_px + side_px; ++y) {
    for (int32_t x = left_px; x < left_px + side_px; ++x) raster.set(x, y, colour);
  }
}

void frame(Raster& raster, int32_t left_px, int32_t top_px, int32_t side_px) {
  for (int32_t i = 0; i < side_px; ++i) {
    raster.set(left_px + i, top_px, kFrame);
    raster.set(left_px + i, top_px + side_px - 1, kFrame);
    raster.set(left_px, top_px + i, kFrame);
    raster.set(left_px + side_px - 1, top_px + i, kFrame);
  }
}

}  // namespace

Raster counterexample_picture(const spec::Subject& subject, const spec::Violation& violation) {
  const spec::Picture drawn = spec::draw(subject, violation.shown);
  const spec::Picture expected = spec::expected(violation.shown);
  const Palette palette(violation.shown);
  const Point blamed = focus(violation, drawn, expected);
  const View view = view_around(drawn, blamed.x_px, blamed.y_px);
  const int32_t step_px = view.width_px * view.scale + kGapPx;
  Raster raster = filled(3 * step_px + kGapPx, view.height_px * view.scale + 2 * kGapPx, kGap);
  for (int32_t y = view.top_px; y < view.top_px + view.height_px; ++y) {
    for (int32_t x = view.left_px; x < view.left_px + view.width_px; ++x) {
      const Pixel& got = drawn.at(x, y);
      const Pixel& wanted = expected.at(x, y);
      const Colour wanted_colour = palette.of(wanted, x, y);
      const Colour panels[] = {palette.of(got, x, y), wanted_colour,
                               got == wanted ? dim(wanted_colour) : kDiffers};
      const int32_t top = kGapPx + (y - view.top_px) * view.scale;
      for (int32_t panel = 0; panel < 3; ++panel) {
        const int32_t left = kGapPx + panel * step_px + (x - view.left_px) * view.scale;
        fill(raster, left, top, view.scale, panels[panel]);
        if (x == violation.x_px && y == violation.y_px) frame(raster, left, top, view.scale);
      }
    }
  }
  return raster;
}

}  // namespace selvage::cli
