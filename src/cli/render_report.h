// What `selvage render` tells about a picture: the choice for each face, and how much was done.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/bitmap.h"
#include "scene/draw.h"

namespace selvage::cli {

struct RenderStats {
  scene::Counts counts;
  std::map<std::string, int64_t> drawn_by;  // faces, by method
  int64_t pieces = 0, written_px = 0, shown_px = 0;
  int64_t compose_ns = 0, draw_ns = 0;

  void add(const RenderStats& other);
};

// What a face is drawn by: the mapper's own word, by selvage_choose, for the whole face.
struct FaceChoice {
  std::string method;
  int32_t segment_px = 0;
  double bound_texel = 0;
};
[[nodiscard]] FaceChoice choice_of(const scene::Scene& scene, const scene::Drawing& drawing,
                                   size_t face, Bitmap& target);

// All but the times.
[[nodiscard]] RenderStats stats_of(const scene::Scene& scene, const scene::Drawing& drawing,
                                   Bitmap& target);

// A face each, in the order of the scene.
[[nodiscard]] nlohmann::ordered_json explanation(const scene::Scene& scene,
                                                 const scene::Drawing& drawing, double tolerance,
                                                 Bitmap& target);
[[nodiscard]] std::string explanation_text(const nlohmann::ordered_json& faces);

[[nodiscard]] nlohmann::ordered_json stats_json(const RenderStats& stats, int32_t frames);
[[nodiscard]] std::string stats_text(const RenderStats& stats, int32_t frames);

}  // namespace selvage::cli
