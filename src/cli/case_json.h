// A case as JSON that people and programs read: sizes, options and vertices in the units of the
// C interface. It is told beside the digits that replay it, and never read back.
#pragma once

#include <nlohmann/json.hpp>

#include "spec/case.h"

namespace selvage::cli {

[[nodiscard]] nlohmann::ordered_json case_json(const spec::Case& c);

}  // namespace selvage::cli
