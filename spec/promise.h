// What is left of a law for a subject that claims less than its profile.
#pragma once

#include <string_view>

#include "spec/capabilities.h"
#include "spec/profiles.h"

namespace selvage::spec {

// How a law stands with a profile, of which so much is claimed.
[[nodiscard]] Promise promise(selvage_profile id, const Capabilities& claims, std::string_view law);

}  // namespace selvage::spec
