// A subject: anything with the draw call, and maybe one for many polygons. The laws know nothing
// else about it.
#pragma once

#include <functional>
#include <string>

#include "selvage.h"

namespace selvage::spec {

// As selvage_draw_many, without what is not the laws' affair: scratch memory, who failed.
using DrawMany =
    std::function<selvage_status(const selvage_image*, const selvage_rect*, const selvage_polygon*,
                                 size_t, const selvage_options*, int32_t threads)>;

struct Subject {
  std::string name;
  std::function<selvage_status(const selvage_image*, const selvage_rect*, const selvage_vertex*,
                               size_t, const selvage_texture*, const selvage_options*)>
      draw;
  selvage_profile profile = SELVAGE_PROFILE_EXACT;  // the one it is held to
  // It has no other filter: verify() draws with nearest alone, and others must get
  // SELVAGE_ERROR_FILTER.
  bool nearest_only = false;
  DrawMany draw_many{};  // may be empty: then nothing is said of it
};

// The mapper that this program is linked with.
[[nodiscard]] Subject built_in(selvage_profile profile = SELVAGE_PROFILE_EXACT);

}  // namespace selvage::spec
