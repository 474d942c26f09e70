// A scene's drawing held against the exact model: every pixel, its error, its bound, the tolerance.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/raster.h"
#include "reports/scenes/choices.h"
#include "reports/scenes/exact_view.h"

namespace selvage::reports {

// What was found at one pixel.
struct JudgedPixel {
  int32_t x_px = 0, y_px = 0;
  Choice choice = Choice::kOneColour;
  double measured_texel = 0, bound_texel = 0, tolerance_texel = 0;
  bool wrong_texel = false;   // not the exact one
  bool right_colour = true;   // that of what it was drawn by, or of the one colour there
  bool right_surface = true;  // drawn where the model shows a texture, and nowhere else
};

// Which promise the pixel breaks, in words; empty if none: measured <= bound <= tolerance, and
// where the bound is 0, the exact texel.
[[nodiscard]] std::optional<std::string> breach(const JudgedPixel& pixel);

struct Verdict {
  uint64_t textured_px = 0;   // by the model
  uint64_t wrong_texels = 0;  // nearest: not the exact texel
  double largest_texel = 0, sum_texel = 0, bound_texel = 0;
  std::array<uint64_t, kChoices> choice_px{};
  uint64_t breaches = 0;
  std::string first_breach;

  [[nodiscard]] double mean_texel() const {
    return textured_px == 0 ? 0 : sum_texel / static_cast<double>(textured_px);
  }
};

// What the mapper drew: the scene's picture, and for the faces of filter nearest the place of each
// texel instead of its colour, drawn by the same calls from a texture of places.
struct Drawn {
  cli::Raster picture;
  std::vector<uint32_t> places;  // kNoPlace where no such face was drawn
};
inline constexpr uint32_t kNoPlace = 0xFFFFFFFF;
[[nodiscard]] Drawn draw_both(const scene::Scene& scene, const scene::Drawing& drawing,
                              const scene::Size& size);

// All pixels. With nearest a pixel's error is the distance of the exact (u, v) from the texel that
// was drawn; with a filter, how far the drawn polygon's own exact (u, v) is from it.
[[nodiscard]] Verdict judge(const scene::Scene& scene, const scene::Drawing& drawing,
                            const ExactView& exact, const RowChoices& choices, const Drawn& drawn,
                            double tolerance_texel);

// How far u is from [texel, texel + 1), in a texture of so many texels.
[[nodiscard]] double distance_texel(const spec::Rational& u, int32_t texel, int32_t size_texel,
                                    selvage_address address);

}  // namespace selvage::reports
