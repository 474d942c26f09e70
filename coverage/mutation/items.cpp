#include "coverage/mutation/items.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <string_view>

#include "spec/generate.h"
#include "spec/hard_cases.h"
#include "spec/laws.h"
#include "spec/profiles.h"

namespace selvage::mutation {
namespace {

struct NamedKernel {
  selvage_kernel kernel;
  std::string_view name;
};
inline constexpr std::array kKernels = {
    NamedKernel{SELVAGE_KERNEL_FASTEST, "fastest"}, NamedKernel{SELVAGE_KERNEL_SCALAR, "scalar"},
    NamedKernel{SELVAGE_KERNEL_SSE4, "SSE4"}, NamedKernel{SELVAGE_KERNEL_AVX2, "AVX2"},
    NamedKernel{SELVAGE_KERNEL_AVX512, "AVX-512"}};
inline constexpr std::array<uint64_t, 2> kSmallSeeds = {0, 1};  // of hard families
inline constexpr int kRoundOfHardCases = 4, kRoundOfTests = 5;

// A kernel that the machine lacks is the fastest.
[[nodiscard]] spec::Subject drawing_by(selvage_kernel kernel) {
  spec::Subject subject = spec::built_in();
  if (selvage_has_kernel(kernel) != 0) spec::take_kernel(kernel, &subject);
  return subject;
}

[[nodiscard]] Item item_of(const spec::Law& law, spec::Case c, std::string name, uint64_t number,
                           int round) {
  const NamedKernel& by = kKernels[number % kKernels.size()];
  Item item;
  item.killer = "law " + std::string(law.name);
  item.on = std::move(name) + ", kernel " + std::string(by.name);
  item.round = round;
  item.breaks = [&law, c = std::move(c), kernel = by.kernel] {
    return law.check(drawing_by(kernel), c).violation.has_value();
  };
  return item;
}

void add_cases(const spec::Law& law, uint64_t first_seed, uint64_t seeds,
               std::vector<Item>* items) {
  for (uint64_t i = 0; i < seeds; ++i) {
    const uint64_t seed = first_seed + i;
    items->push_back(item_of(law, spec::generate(seed), "seed " + std::to_string(seed), i,
                             static_cast<int>(std::bit_width(i))));
  }
  uint64_t number = 0;
  for (const spec::HardFamily& family : spec::hard_families()) {
    for (const uint64_t seed : kSmallSeeds) {
      items->push_back(item_of(law, family.make(seed),
                               std::string(family.name) + " " + std::to_string(seed), number++,
                               kRoundOfHardCases));
    }
  }
}

// Runs one test by itself.
[[nodiscard]] bool test_breaks(const std::string& name) {
  testing::GTEST_FLAG(filter) = name;
  return RUN_ALL_TESTS() != 0;
}

void add_tests(std::vector<Item>* items) {
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int s = 0; s < all.total_test_suite_count(); ++s) {
    const testing::TestSuite& suite = *all.GetTestSuite(s);
    for (int t = 0; t < suite.total_test_count(); ++t) {
      const std::string name = std::string(suite.name()) + "." + suite.GetTestInfo(t)->name();
      items->push_back({"test " + name, "", kRoundOfTests, [name] { return test_breaks(name); }});
    }
  }
}

}  // namespace

std::vector<Item> all_items(uint64_t first_seed, uint64_t seeds) {
  std::vector<Item> items;
  for (const spec::Law& law : spec::laws()) {
    if (!spec::is_promised(SELVAGE_PROFILE_EXACT, law.name)) continue;
    add_cases(law, first_seed, seeds, &items);
  }
  add_tests(&items);
  std::ranges::stable_sort(items, {}, &Item::round);
  return items;
}

}  // namespace selvage::mutation
