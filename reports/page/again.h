// The matrix's second pass: what the first one found on one row is tried on all others.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/corpus.h"
#include "reports/page/matrix.h"

namespace selvage::reports {

// The violations that are new on other rows, of laws that the row `id` kept and that none of its
// findings is about.
[[nodiscard]] std::vector<cli::KnownCase> to_try_again(const std::vector<MatrixRow>& rows,
                                                       const nlohmann::ordered_json& findings,
                                                       const std::string& id);

// The first verdict of a row, with the laws that its second one saw violated.
[[nodiscard]] nlohmann::ordered_json with_second(nlohmann::ordered_json first,
                                                 const nlohmann::ordered_json& second);

}  // namespace selvage::reports
