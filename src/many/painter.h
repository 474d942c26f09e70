// The painter: prepared polygons drawn one after another.
#pragma once

#include <optional>

#include "draw_call.h"
#include "many/one_ahead.h"
#include "many/prepare.h"
#include "many/small_queue.h"
#include "mapper/kernel.h"
#include "mapper/kernel_choice.h"
#include "selvage.h"

namespace selvage::many {

// What a texture decides is found when another one comes. Small polygons and triangles may wait:
// one of these is drawn before one of those is kept, and the other way round.
class Painter {
 public:
  Painter(const Request& request, const selvage_rect& visible)
      : options_(request.options),
        visible_(visible),
        keeps_(options_.profile == SELVAGE_PROFILE_EXACT && options_.filter != SELVAGE_FILTER_AREA),
        surface_{request.target, *request.prepared[0].texture, options_.address} {
    change_to(request.prepared[0].texture);
  }

  // What is drawn of those that come.
  void show(const selvage_rect& visible) { visible_ = visible; }
  // All that came before is drawn, but maybe those that are kept.
  void draw(const Prepared& one) {
    if (one.texture != known_) {
      finish();
      change_to(one.texture);
    }
    if (keeps_ && small_->takes(one.polygon)) {
      ahead_.finish(surface_);
      return small_->add(one.polygon, visible_, surface_);
    }
    small_->finish(surface_);
    const mapper::Kernels& kernels = kernels_->of(one.polygon);
    if (keeps_ && ahead_.find(one.polygon, visible_, surface_, kernels)) return;
    ahead_.finish(surface_);
    draw_checked(surface_, visible_, one.polygon, options_, kernels);
  }
  // Draws those, too.
  void finish() {
    small_->finish(surface_);
    ahead_.finish(surface_);
  }

 private:
  void change_to(const selvage_texture* texture) {
    known_ = texture;
    surface_.texture = *texture;
    kernels_.emplace(options_, *texture);
    small_.emplace(kernels_->of_work(SELVAGE_WORK_MESH), *texture, options_.address);
  }

  selvage_options options_;
  selvage_rect visible_;
  bool keeps_;  // whether any polygons may be kept
  mapper::Surface surface_;
  const selvage_texture* known_ = nullptr;
  std::optional<mapper::KernelChoice> kernels_;
  std::optional<SmallQueue> small_;
  OneAhead ahead_;
};

}  // namespace selvage::many
