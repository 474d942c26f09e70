// What may kill a mutant: a law on a case, or a unit test. Each says whether it is broken.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace selvage::mutation {

struct Item {
  std::string killer;            // "law MAP" or "test Snap.RoundsHalvesUp"
  std::string on;                // the case: its seed or family, and the kernel; empty for a test
  int round = 0;                 // items of lower rounds come first
  std::function<bool()> breaks;  // runs it
  std::vector<bool> reaches{};   // by a site's first number; filled in by record()
  double cost_s = 0;             // of processor time, by record()
};

// Laws of the exact profile x `seeds` generated cases and those of the hard families, drawn by each
// kernel in turn; then every unit test that this program is linked with. In the order in which they
// are to be tried.
[[nodiscard]] std::vector<Item> all_items(uint64_t first_seed, uint64_t seeds);

}  // namespace selvage::mutation
