// What selvage_draw and selvage_draw_many share: the checks in their order, and the drawing of what
// has passed them.
#pragma once

#include <span>

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
[[nodiscard]] selvage_status check_outline(const selvage_options& options,
                                           std::span<const selvage_vertex> vertices,
                                           mapper::Polygon* polygon);

// Draws by the profile of the options what has passed every check. `visible` lies within the target
// or is empty; no other row is written, or read.
void draw_checked(const selvage_image& target, const selvage_rect& visible,
                  const mapper::Polygon& polygon, const selvage_texture& texture,
                  const selvage_options& options);

}  // namespace selvage
