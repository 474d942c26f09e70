// What `selvage render` tells of how much was done, and how fast.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/bitmap.h"
#include "scene/draw.h"

namespace selvage::cli {

// Faces are the scene's, also where one is drawn as several triangles or under several clips.
struct RenderStats {
  struct Way {  // "several" where a face's triangles differ
    std::string method, filter, kernel;
    friend auto operator<=>(const Way&, const Way&) = default;
  };
  struct Work {
    int64_t faces = 0, pixels = 0;
  };
  scene::Counts counts;
  std::map<Way, Work> drawn_by;
  int64_t draw_calls = 0;
  int64_t written_px = 0;  // each as often as it was written
  int64_t shown_px = 0;    // of the picture, where a face shows
  int64_t compose_ns = 0;
  int64_t light_ns = 0;  // of textures
  int64_t sums_ns = 0;   // of textures, to make them
  int64_t draw_ns = 0;   // of selvage_draw, without the above

  void add(const RenderStats& other);
};

// All but the times.
[[nodiscard]] RenderStats stats_of(const scene::Scene& scene, const scene::Drawing& drawing,
                                   Bitmap& target);

// "faces" is the sum of "faces_culled" and "faces_drawn", this that of "drawn_by".
[[nodiscard]] nlohmann::ordered_json stats_json(const RenderStats& stats, int32_t frames);
[[nodiscard]] std::string stats_text(const RenderStats& stats, int32_t frames);

}  // namespace selvage::cli
