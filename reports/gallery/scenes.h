// The gallery.
#pragma once

#include <vector>

#include "reports/gallery/pictures.h"
#include "reports/gallery/scene.h"

namespace selvage::reports {

[[nodiscard]] Scene turned_map(const Pictures& pictures);
[[nodiscard]] Scene endless_plane(const Pictures& pictures);
[[nodiscard]] Scene globe_scene(const Pictures& pictures);
[[nodiscard]] Scene wave_scene(const Pictures& pictures);
[[nodiscard]] Scene pinwheel(const Pictures& pictures);
[[nodiscard]] Scene checker_of_ties(const Pictures& pictures);
[[nodiscard]] Scene moire(const Pictures& pictures);
[[nodiscard]] Scene spacecraft(const Pictures& pictures);

// All of them, in the order of the page. The pictures must outlive the scenes.
[[nodiscard]] std::vector<Scene> scenes(const Pictures& pictures);

}  // namespace selvage::reports
