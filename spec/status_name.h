// What a call has answered, for people.
#pragma once

#include <string>

#include "selvage.h"

namespace selvage::spec {

// "3 (SELVAGE_ERROR_TARGET_SIZE)"; "77 (no selvage_status)".
[[nodiscard]] std::string status_name(selvage_status status);

}  // namespace selvage::spec
