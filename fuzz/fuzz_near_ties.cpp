// Bytes -> a case, led towards coordinates that lie next to whole numbers at ever more pixels: what
// they cost stays within the bounds of fuzz/near_ties.h, and every kernel draws the exact picture.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz/laws_limits.h"
#include "fuzz/near_ties.h"
#include "spec/laws.h"
#include "spec/subject.h"

namespace {

namespace spec = selvage::spec;
using selvage::fuzz::NearTies;

// libFuzzer keeps an input that sets a counter which none before it has set. One for each kind of
// map, texels or grid, and share: of coordinates that are near-ties, and of runs of pixels that
// have one. A run is paid for as a whole: a near-tie in each may cost as much as many.
constexpr int kShares = 64;
struct SharesReached {
  uint8_t of_coordinates[kShares], of_runs[kShares];
};
__attribute__((used, section("__libfuzzer_extra_counters")))
SharesReached reached[selvage::fuzz::kMapKinds][2];

void reward(const NearTies& ties, bool on_grid) {
  if (ties.near == 0) return;
  SharesReached& shares = reached[static_cast<int>(ties.kind)][on_grid ? 1 : 0];
  const auto share = [](int64_t part, int64_t all) { return part * (kShares - 1) / all; };
  shares.of_coordinates[share(ties.near, ties.coordinates)] = 1;
  shares.of_runs[share(ties.near_runs, ties.runs)] = 1;
}

[[noreturn]] void report(const char* what, const spec::Case& c) {
  std::fprintf(stderr, "near-ties: %s\ncase: %s\n", what, spec::to_hex(c).c_str());
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static const spec::Subject mapper = spec::built_in();
  spec::Case c = spec::decode({data, size});
  c.profile = SELVAGE_PROFILE_EXACT;
  if (!spec::can_be_filtered(c) || c.filter == SELVAGE_FILTER_AREA) {
    c.filter = SELVAGE_FILTER_NEAREST;
  }
  if (!selvage::fuzz::is_taken(c)) return -1;
  const NearTies ties = selvage::fuzz::count_near_ties(c);
  if (ties.fault != nullptr) report(ties.fault, c);
  reward(ties, c.filter != SELVAGE_FILTER_NEAREST);
  for (const char* name : {"MAP", "FILTER", "SAME"}) {
    const spec::Judgement judgement = spec::find_law(name)->check(mapper, c);
    if (judgement.violation) report(spec::explain(*judgement.violation).c_str(), c);
  }
  return 0;
}
