// A scene's picture, and a turn of it as an animated PNG.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "cli/raster.h"
#include "reports/scenes/shipped.h"

namespace selvage::reports {

// At a time, exact.
[[nodiscard]] cli::Raster picture(const scene::Scene& scene, std::optional<selvage_filter> filter,
                                  double time_s, const scene::Size& size);

// So many frames, spread evenly over the turn.
[[nodiscard]] std::vector<uint8_t> animation(const scene::Scene& scene, const Shipped& shipped,
                                             const scene::Size& size, uint32_t frames,
                                             const std::function<void()>& tick);

}  // namespace selvage::reports
