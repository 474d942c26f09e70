// What the planner, and below it the mapper, draws each row of each face by.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "cli/raster.h"
#include "scene/draw.h"

namespace selvage::reports {

enum class Choice : uint8_t {
  kOneColour,
  kExactAffine,
  kAffineFaceNearest,
  kAffineFaceFiltered,
  kAffineRow,
  kSubdivided,
  kExactNearest,
  kExactFiltered
};
inline constexpr size_t kChoices = 8;

struct ChoiceStyle {
  std::string_view id, title;
  cli::Colour colour;
};
[[nodiscard]] const ChoiceStyle& style_of(Choice choice);
[[nodiscard]] inline Choice choice_number(size_t index) { return static_cast<Choice>(index); }

struct RowChoice {
  Choice choice = Choice::kOneColour;
  int32_t segment_px = 0;  // where the row is subdivided
  double bound_texel = 0;  // of u and of v
};

class RowChoices {
 public:
  RowChoices(const scene::Scene& scene, const scene::Drawing& drawing, const scene::Size& size);
  [[nodiscard]] const RowChoice& at(size_t face, int32_t y_px) const {
    return rows_[face * static_cast<size_t>(height_px_) + static_cast<size_t>(y_px)];
  }

 private:
  int32_t height_px_;
  std::vector<RowChoice> rows_;
};

}  // namespace selvage::reports
