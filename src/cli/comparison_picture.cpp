#include "cli/comparison_picture.h"

#include <algorithm>
#include <string_view>

#include "cli/bitmap_font.h"

namespace selvage::cli {
namespace {

constexpr int32_t kWindowPx = 96;  // the most of a target that is shown, a side
constexpr int32_t kPanelPx = 384;  // about the side of a panel
constexpr int32_t kMaxScale = 32;  // px of the picture for one of the target
constexpr int32_t kGapPx = 8;
constexpr std::string_view kCaptions[] = {"drawn", "expected", "difference"};
constexpr int32_t kPanels = 3;
constexpr int32_t kDot_px = 2;  // of a caption
constexpr int32_t kCaptionPx = kGlyphHeight_dots * kDot_px;
constexpr int32_t kLeastPanelPx = 10 * kGlyphWidth_dots * kDot_px;  // the widest caption
constexpr Colour kGap{24, 24, 24};
constexpr Colour kUnknown{255, 0, 255};
constexpr Colour kFrame{255, 255, 255}, kInk{222, 224, 228};

using Pixel = std::optional<uint32_t>;

// The colours of the coordinate texture's texels.
class Palette {
 public:
  Palette(const spec::Case& c, bool colours)
      : width_texel_(c.texture_width_texel),
        height_texel_(c.texture_height_texel),
        shows_colours_(colours) {}

  [[nodiscard]] Colour of(uint32_t pixel) const {
    if (shows_colours_) {
      const auto channel = [&](int i) { return static_cast<uint8_t>(spec::channel(pixel, i)); };
      return {channel(0), channel(1), channel(2)};
    }
    const auto [s, t] = spec::texel_of(pixel);
    if (s >= width_texel_ || t >= height_texel_) return kUnknown;
    const uint8_t blue = (s + t) % 2 == 0 ? 120 : 40;  // so that neighbours differ
    return {ramp(s, width_texel_), ramp(t, height_texel_), blue};
  }

 private:
  [[nodiscard]] static uint8_t ramp(int32_t at, int32_t size) {
    return static_cast<uint8_t>(size > 1 ? 40 + 215 * int64_t{at} / (size - 1) : 147);
  }

  int32_t width_texel_, height_texel_;
  bool shows_colours_;
};

// The part of the target that is shown, how large, and where its panels lie.
struct View {
  int32_t left_px, top_px, width_px, height_px;
  int32_t scale;
  bool stacked;

  // From one panel to the next, with its caption above it.
  [[nodiscard]] int32_t across_px() const {
    return std::max(width_px * scale, kLeastPanelPx) + kGapPx;
  }
  [[nodiscard]] int32_t down_px() const { return kCaptionPx + height_px * scale + kGapPx; }
  [[nodiscard]] int32_t panel_left_px(int32_t panel) const {
    return kGapPx + (stacked ? 0 : panel * across_px());
  }
  [[nodiscard]] int32_t panel_top_px(int32_t panel) const {
    return kGapPx + kCaptionPx + (stacked ? panel * down_px() : 0);
  }
};

[[nodiscard]] int32_t window_start(int32_t centre_px, int32_t window_px, int32_t size_px) {
  return std::clamp(centre_px - window_px / 2, 0, size_px - window_px);
}

[[nodiscard]] View view_around(const spec::Picture& picture, int32_t x_px, int32_t y_px) {
  const bool stacked = picture.width_px > kPanels * picture.height_px;
  const bool tall = picture.height_px > kPanels * picture.width_px;
  const int32_t width = std::min(picture.width_px, kWindowPx);
  const int32_t height = std::min(picture.height_px, tall ? kWindowPx / kPanels : kWindowPx);
  const int32_t room_px = stacked ? kPanels * kPanelPx : kPanelPx;
  return {window_start(x_px, width, picture.width_px),
          window_start(y_px, height, picture.height_px),
          width,
          height,
          std::clamp(room_px / std::max(width, height), 1, kMaxScale),
          stacked};
}

struct Point {
  int32_t x_px, y_px;
};

// The pixel to show: the given one, or the first that differs, or the first of all.
[[nodiscard]] Point focus(const PictureComparison& c) {
  const bool given =
      c.x_px >= 0 && c.x_px < c.drawn.width_px && c.y_px >= 0 && c.y_px < c.drawn.height_px;
  if (given) return {c.x_px, c.y_px};
  const auto differs = std::mismatch(c.drawn.pixels.begin(), c.drawn.pixels.end(),
                                     c.expected.pixels.begin(), c.expected.pixels.end());
  if (differs.first == c.drawn.pixels.end()) return {0, 0};
  const auto index = static_cast<int32_t>(differs.first - c.drawn.pixels.begin());
  return {index % c.drawn.width_px, index / c.drawn.width_px};
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

// A square of chequerboard, four of its squares if they fit: one pixel alone shows what it is.
void fill_undrawn(Raster& raster, int32_t left_px, int32_t top_px, int32_t side_px, bool is_dim) {
  for (int32_t y = 0; y < side_px; ++y) {
    for (int32_t x = 0; x < side_px; ++x) {
      const int32_t at_x = left_px + x, at_y = top_px + y;
      const int32_t squares = side_px > 1 ? 2 * x / side_px + 2 * y / side_px : at_x + at_y;
      const uint8_t grey = squares % 2 == 0 ? 96 : 128;
      const Colour colour{grey, grey, grey};
      raster.set(at_x, at_y, is_dim ? dim(colour) : colour);
    }
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

// One pixel in one panel, at `left_px`, `top_px` of the picture.
void paint(Raster& raster, const PictureComparison& c, const Palette& palette, Point at,
           int32_t panel, int32_t left_px, int32_t top_px, int32_t side_px) {
  const Pixel& got = c.drawn.at(at.x_px, at.y_px);
  const Pixel& wanted = c.expected.at(at.x_px, at.y_px);
  const bool is_difference = panel == kPanels - 1;
  const Pixel& pixel = panel == 0 ? got : wanted;
  if (is_difference && got != wanted) {
    fill(raster, left_px, top_px, side_px, c.difference(got, wanted));
  } else if (!pixel) {
    fill_undrawn(raster, left_px, top_px, side_px, is_difference);
  } else {
    const Colour colour = palette.of(*pixel);
    fill(raster, left_px, top_px, side_px, is_difference ? dim(colour) : colour);
  }
  if (at.x_px == c.x_px && at.y_px == c.y_px) frame(raster, left_px, top_px, side_px);
}

}  // namespace

Raster comparison_picture(const PictureComparison& c) {
  const Palette palette(c.scene, c.colours);
  const Point shown = focus(c);
  const View view = view_around(c.drawn, shown.x_px, shown.y_px);
  Raster raster = filled(view.panel_left_px(view.stacked ? 0 : kPanels - 1) + view.across_px(),
                         (view.stacked ? kPanels : 1) * view.down_px() + kGapPx, kGap);
  for (int32_t panel = 0; panel < kPanels; ++panel) {
    draw_text(raster, view.panel_left_px(panel), view.panel_top_px(panel) - kCaptionPx, kDot_px,
              kCaptions[panel], kInk);
    for (int32_t y = 0; y < view.height_px; ++y) {
      for (int32_t x = 0; x < view.width_px; ++x) {
        paint(raster, c, palette, {view.left_px + x, view.top_px + y}, panel,
              view.panel_left_px(panel) + x * view.scale, view.panel_top_px(panel) + y * view.scale,
              view.scale);
      }
    }
  }
  return raster;
}

}  // namespace selvage::cli
