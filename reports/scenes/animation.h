// A turn of a scene as an animated PNG.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "reports/scenes/shipped.h"

namespace selvage::reports {

// So many frames, spread evenly over the turn, within the scene's own tolerance.
[[nodiscard]] std::vector<uint8_t> animation(const scene::Scene& scene, double turn_s,
                                             const scene::Size& size, uint32_t frames,
                                             const std::function<void()>& tick);

}  // namespace selvage::reports
