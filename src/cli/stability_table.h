// What a run of `selvage stability` measured, for people and for programs.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/stability/measure.h"

namespace selvage::cli {

struct StabilityRun {
  std::string subject;
  uint64_t seed = 0, cases = 0;  // of each family
  std::vector<stability::FamilyRow> families;
  std::string arguments{};  // "--subject ./theirs.so ...": how the subject is told again
};

// No promise was broken.
[[nodiscard]] bool passed(const StabilityRun& run);

// The command that measures the worst case of a cell again, alone.
[[nodiscard]] std::string worst_line(const StabilityRun& run, const stability::FamilyRow& row,
                                     const stability::Cell& cell);

// At most 100 columns: a family's reason, a row for each arithmetic.
[[nodiscard]] std::string stability_block(const stability::FamilyRow& row);
// What the columns mean, and what they do not.
[[nodiscard]] std::string_view stability_notes();
// The notes, and what was broken.
[[nodiscard]] std::string stability_summary(const StabilityRun& run);

[[nodiscard]] std::string stability_json(const StabilityRun& run,
                                         std::span<const stability::Contender> contenders);

// The families with their reasons and the arithmetics with their statements.
[[nodiscard]] std::string stability_list(std::span<const stability::Contender> contenders);
[[nodiscard]] std::string stability_list_json(std::span<const stability::Contender> contenders);

}  // namespace selvage::cli
