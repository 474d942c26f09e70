// The violations that are tried first on a row of the matrix.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/corpus.h"

namespace selvage::reports {

// Of a law that a finding of the row explains, the case that it was found on: what the row then
// shows is what the finding is about, and if the case passes, the finding is stale. Of other laws
// the cases of all other rows' findings, and those of `corpus`.
[[nodiscard]] std::vector<cli::KnownCase> known_cases(const nlohmann::ordered_json& findings,
                                                      const std::string& id,
                                                      const std::vector<cli::KnownCase>& corpus);

}  // namespace selvage::reports
