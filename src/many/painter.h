// The painter: prepared polygons drawn one after another.
#pragma once

#include "draw_call.h"
#include "many/prepare.h"
#include "mapper/kernel.h"
#include "mapper/kernel_choice.h"
#include "selvage.h"

namespace selvage::many {

// What a texture decides is found when another one comes.
class Painter {
 public:
  Painter(const Request& request, const selvage_rect& visible)
      : options_(request.options),
        visible_(visible),
        surface_{request.target, *request.prepared[0].texture, options_.address},
        known_(request.prepared[0].texture),
        kernels_(options_, surface_.texture) {}

  void draw(const Prepared& one) {
    if (one.texture != known_) change_to(one.texture);
    draw_checked(surface_, visible_, one.polygon, options_, kernels_.of(one.polygon));
  }

 private:
  void change_to(const selvage_texture* texture) {
    known_ = texture;
    surface_.texture = *texture;
    kernels_ = mapper::KernelChoice(options_, *texture);
  }

  selvage_options options_;
  selvage_rect visible_;
  mapper::Surface surface_;
  const selvage_texture* known_;
  mapper::KernelChoice kernels_;
};

}  // namespace selvage::many
