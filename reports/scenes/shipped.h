// The scenes that come with the project.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "cli/scene_file.h"

namespace selvage::reports {

struct Shipped {
  std::string_view id, title, sentence;
  double turn_s;                         // until it looks as at first
  std::optional<selvage_filter> filter;  // of the picture and the animation; else the planner's
};

inline constexpr std::array<Shipped, 2> kShipped{
    {{"station", "A space station",
      "A ball of quads and triangles and a ring around it, each turning by itself, in a light. A "
      "bear looks out of a window; the other faces of the ball have one colour each, but for a "
      "hatch and solar cells.",
      9, std::nullopt},
     {"globe", "A globe",
      "A map of our own drawing on a ball of quads and triangles that share their vertices and, "
      "along every edge, the texture: it runs on without a seam.",
      12, SELVAGE_FILTER_BILINEAR}}};

[[nodiscard]] inline scene::Scene read_shipped(const std::filesystem::path& folder,
                                               const Shipped& shipped) {
  return cli::read_scene(folder / shipped.id / (std::string(shipped.id) + ".json"));
}

}  // namespace selvage::reports
