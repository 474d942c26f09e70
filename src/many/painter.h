// The painter: prepared polygons drawn one after another.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "draw_call.h"
#include "many/prepare.h"
#include "mapper/kernel.h"
#include "mapper/kernel_choice.h"
#include "mapper/plane_draw.h"
#include "mapper/polygon.h"
#include "selvage.h"

namespace selvage::many {

// What a texture decides is found when another one comes. Small triangles are found one ahead of
// what is drawn.
class Painter {
 public:
  Painter(const Request& request, const selvage_rect& visible)
      : options_(request.options),
        visible_(visible),
        finds_ahead_(options_.profile == SELVAGE_PROFILE_EXACT &&
                     options_.filter != SELVAGE_FILTER_AREA),
        surface_{request.target, *request.prepared[0].texture, options_.address},
        known_(request.prepared[0].texture),
        kernels_(options_, surface_.texture) {}

  // All that came before is drawn, but maybe the last one.
  void draw(const Prepared& one) {
    if (one.texture != known_) change_to(one.texture);
    const mapper::Kernels& kernels = kernels_.of(one.polygon);
    if (find(one.polygon, kernels)) return;
    finish();
    draw_checked(surface_, visible_, one.polygon, options_, kernels);
  }
  // Draws that one, too.
  void finish() {
    if (!has_last_) return;
    found_[last_]->draw(surface_);
    has_last_ = false;
  }

 private:
  // Finds one before the last one is drawn. False where it is not one to be found.
  [[nodiscard]] bool find(const mapper::Polygon& polygon, const mapper::Kernels& kernels) {
    const selvage_rect part = mapper::part_of(polygon, visible_);
    if (!is_small_triangle(polygon, part)) return false;
    const size_t next = 1 - last_;
    if (!found_[next].emplace(polygon, part, kernels).has_plane()) return false;
    finish();
    last_ = next;
    has_last_ = true;
    return true;
  }
  [[nodiscard]] bool is_small_triangle(const mapper::Polygon& polygon,
                                       const selvage_rect& part) const {
    return polygon.vertices.size() == 3 && !mapper::is_empty(part) &&
           mapper::PlaneDraw::fits(polygon, part) && !polygon.untransformed && finds_ahead_;
  }

  void change_to(const selvage_texture* texture) {
    finish();
    known_ = texture;
    surface_.texture = *texture;
    kernels_ = mapper::KernelChoice(options_, *texture);
  }

  selvage_options options_;
  selvage_rect visible_;
  bool finds_ahead_;
  mapper::Surface surface_;
  const selvage_texture* known_;
  mapper::KernelChoice kernels_;
  std::array<std::optional<mapper::PlaneDraw>, 2> found_;
  size_t last_ = 0;
  bool has_last_ = false;  // the other one is never waiting to be drawn
};

}  // namespace selvage::many
