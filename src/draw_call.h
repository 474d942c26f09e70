// What selvage_draw and selvage_draw_many share: the checks in their order, and the drawing of what
// has passed them.
#pragma once

#include <span>

#include "historic/whole_px.h"
#include "mapper/kernel.h"
#include "mapper/polygon.h"
#include "selvage.h"

namespace selvage {

// Of a whole call: options, then target.
[[nodiscard]] selvage_status check_call(const selvage_options& options,
                                        const selvage_image* target);

// Of a texture on a target that has passed its checks.
[[nodiscard]] selvage_status check_source(const selvage_options& options,
                                          const selvage_image& target,
                                          const selvage_texture* texture);

// Of an outline. On SELVAGE_OK *polygon refers to `vertices`.
[[nodiscard]] inline selvage_status check_outline(const selvage_options& options,
                                                  std::span<const selvage_vertex> vertices,
                                                  mapper::Polygon* polygon) {
  const selvage_status status = mapper::examine(vertices, polygon);
  if (status != SELVAGE_OK || options.profile == SELVAGE_PROFILE_EXACT) return status;
  return historic::check_whole_px(*polygon);
}

// Draws by the profile of the options what has passed every check. `visible` lies within the target
// or is empty; no other row is written, or read. The kernels are those chosen for the polygon, and
// serve profile exact.
void draw_checked(const mapper::Surface& surface, const selvage_rect& visible,
                  const mapper::Polygon& polygon, const selvage_options& options,
                  const mapper::Kernels& kernels);

}  // namespace selvage
