#include "cli/seeds.h"

#include <optional>
#include <random>

#include "cli/error.h"
#include "cli/number.h"

namespace selvage::cli {

uint64_t case_count(const std::string& text) {
  constexpr uint64_t most = 1'000'000'000;
  const std::optional<uint64_t> count = parse_integer<uint64_t>(text);
  if (!count || *count < 1 || *count > most) {
    throw UserError("--cases: '" + text + "' is no number from 1 to " + std::to_string(most));
  }
  return *count;
}

uint64_t first_seed(const std::string& text) {
  if (text.empty()) {
    std::random_device device;
    return (uint64_t{device()} << 21 ^ device()) & ((uint64_t{1} << 53) - 1);
  }
  const std::optional<uint64_t> seed = parse_integer<uint64_t>(text);
  if (!seed) throw UserError("--seed: '" + text + "' is no number from 0 to 2^64 - 1");
  return *seed;
}

}  // namespace selvage::cli
