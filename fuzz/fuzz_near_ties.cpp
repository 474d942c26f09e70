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
// map, texels or grid, and share of near-ties.
constexpr int kShares = 64;
__attribute__((section("__libfuzzer_extra_counters")))
uint8_t share_reached[selvage::fuzz::kMapKinds * 2 * kShares];

void reward(const NearTies& ties, bool on_grid) {
  if (ties.near == 0) return;
  const auto share = static_cast<int>(ties.near * (kShares - 1) / ties.coordinates);
  share_reached[(static_cast<int>(ties.kind) * 2 + (on_grid ? 1 : 0)) * kShares + share] = 1;
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
