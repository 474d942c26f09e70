// A subject: anything with the draw call. The laws know nothing else about it.
#pragma once

#include <functional>
#include <string>

#include "selvage.h"

namespace selvage::spec {

struct Subject {
  std::string name;
  std::function<selvage_status(const selvage_image*, const selvage_rect*, const selvage_vertex*,
                               size_t, const selvage_texture*, const selvage_options*)>
      draw;
  selvage_profile profile = SELVAGE_PROFILE_EXACT;  // the one it is held to
  bool nearest_only = false;  // it has no other filter: verify() draws with nearest alone, and
                              // others must get SELVAGE_ERROR_FILTER
};

// The mapper that this program is linked with.
[[nodiscard]] Subject built_in(selvage_profile profile = SELVAGE_PROFILE_EXACT);

}  // namespace selvage::spec
