// Triangles of which each is found before the one before it is drawn.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "mapper/kernel.h"
#include "mapper/plane_draw.h"
#include "mapper/polygon.h"
#include "selvage.h"

namespace selvage::many {

class OneAhead {
 public:
  // Draws the last one that was found, once this one is. False where it is not one to be found:
  // nothing is drawn then. Refers to the polygon.
  [[nodiscard]] bool find(const mapper::Polygon& polygon, const selvage_rect& visible,
                          const mapper::Surface& surface, const mapper::Kernels& kernels) {
    const selvage_rect part = mapper::part_of(polygon, visible);
    if (!is_one_batch(polygon, part)) return false;
    const size_t next = 1 - last_;
    if (!found_[next].emplace(polygon, part, kernels).has_plane()) return false;
    finish(surface);
    last_ = next;
    has_last_ = true;
    return true;
  }
  void finish(const mapper::Surface& surface) {
    if (!has_last_) return;
    found_[last_]->draw(surface);
    has_last_ = false;
  }

 private:
  [[nodiscard]] static bool is_one_batch(const mapper::Polygon& polygon, const selvage_rect& part) {
    return polygon.vertices.size() == 3 && !mapper::is_empty(part) &&
           mapper::PlaneDraw::fits(polygon, part) && !polygon.untransformed;
  }

  std::array<std::optional<mapper::PlaneDraw>, 2> found_;
  size_t last_ = 0;
  bool has_last_ = false;  // the other one is never waiting to be drawn
};

}  // namespace selvage::many
