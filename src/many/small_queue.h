// Small polygons that wait until there are as many as one call draws.
#pragma once

#include "mapper/kernel.h"
#include "mapper/polygon.h"
#include "mapper/small_polygons.h"
#include "selvage.h"

namespace selvage::many {

class SmallQueue {
 public:
  // Of one texture. Takes none where the kernels do not draw them.
  SmallQueue(const mapper::Kernels& kernels, const selvage_texture& texture,
             selvage_address address)
      : kernels_(&kernels),
        takes_any_(mapper::SmallPolygons::take_from(texture, kernels.small)),
        ends_(texture, address) {}

  [[nodiscard]] bool takes(const mapper::Polygon& polygon) const {
    return takes_any_ && mapper::SmallPolygons::take(polygon, ends_, kernels_->small);
  }
  // Of a polygon that it takes, to which it refers. Draws those that wait where there is no room.
  void add(const mapper::Polygon& polygon, const selvage_rect& visible,
           const mapper::Surface& surface) {
    const selvage_rect part = mapper::part_of(polygon, visible);
    if (mapper::is_empty(part)) return;
    if (!waiting_.has_room_for(polygon)) finish(surface);
    waiting_.add(polygon, part);
  }
  void finish(const mapper::Surface& surface) {
    if (waiting_.count() == 0) return;
    kernels_->draw_small(waiting_, surface);
    waiting_.clear();
  }

 private:
  const mapper::Kernels* kernels_;
  bool takes_any_;
  mapper::SmallEnds ends_;
  mapper::SmallPolygons waiting_;
};

}  // namespace selvage::many
