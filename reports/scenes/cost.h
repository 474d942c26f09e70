// A drawing as the calls of selvage_draw that it is made of, to be timed.
#pragma once

#include <vector>

#include "scene/draw.h"
#include "scene/paints.h"

namespace selvage::reports {

// Vertices, textures in their light and clip rectangles are ready: what is timed is the mapper.
class Calls {
 public:
  // The scene stays where it is.
  Calls(const scene::Scene& scene, const scene::Drawing& drawing);
  Calls(const Calls&) = delete;
  Calls& operator=(const Calls&) = delete;

  // Over what is there; without a background. Those of textured faces alone, or all.
  void draw(const selvage_image& target, bool textured_only) const;

 private:
  struct Call {
    std::vector<selvage_vertex> vertices;
    selvage_texture texture;
    selvage_rect clip;
    selvage_options options;
    bool textured;
  };

  scene::Paints paints_;
  std::vector<Call> calls_;
};

}  // namespace selvage::reports
