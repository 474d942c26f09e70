// Arithmetics that texture mappers are usually written in: each an honest mapper behind
// selvage_draw's signature, made for the stability table and the plot of speed against error, and
// for nothing else. They take every call that selvage_draw takes, see nothing of the project but
// selvage.h, and may be wrong only in what they draw: never out of bounds, never undefined.
#pragma once

#include <span>
#include <string_view>

#include "selvage.h"

namespace selvage::stability {

struct Arithmetic {
  std::string_view name;
  std::string_view statement;  // number format, what is stepped, what is rounded where
  bool affine_only;            // takes q for equal
  selvage_status (*draw)(const selvage_image* target, const selvage_rect* clip,
                         const selvage_vertex* vertices, size_t count,
                         const selvage_texture* texture, const selvage_options* options);
};

// One file each.
[[nodiscard]] Arithmetic fixed1616();
[[nodiscard]] Arithmetic float32_dda();
[[nodiscard]] Arithmetic float32_plane();
[[nodiscard]] Arithmetic float64_dda();

// All of them, in the order of the table.
[[nodiscard]] std::span<const Arithmetic> arithmetics();

}  // namespace selvage::stability
