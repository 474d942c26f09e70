// A scene's picture: looked at, planned, freed of what is hidden, drawn.
#pragma once

#include <cstddef>
#include <vector>

#include "scene/hidden.h"
#include "scene/look.h"
#include "scene/paints.h"
#include "scene/plan.h"
#include "scene/scene.h"
#include "selvage.h"

namespace selvage::scene {

// All that is decided before a pixel is drawn.
struct Drawing {
  View view;
  std::vector<Plan> plans;  // a face each
  std::vector<Piece> pieces;
};

// The scene has no problem (problem.h).
[[nodiscard]] Drawing compose(const Scene& scene, double time_s, Size size, const Wish& wish,
                              Hidden way);

// The background alone. The target is RGBA8888, here and below.
void clear(const Scene& scene, const selvage_image& target);

// Copies of lit textures take no more than this at once, or than the largest texture.
inline constexpr size_t kLitBytes = size_t{64} << 20;

// The pieces in order; the first error of selvage_draw, if any. What lighting costs of it is told
// by `paints`, which are the scene's.
[[nodiscard]] selvage_status draw_pieces(const Scene& scene, const Drawing& drawing,
                                         const selvage_image& target, Paints& paints);

// Both, one after the other.
[[nodiscard]] selvage_status draw(const Scene& scene, const Drawing& drawing,
                                  const selvage_image& target);

}  // namespace selvage::scene
