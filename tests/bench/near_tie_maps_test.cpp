// The maps that near-ties are searched in are hard where they are called so.
#include "reports/bench/near_tie_maps.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "reports/bench/near_tie_search.h"
#include "spec/exact.h"

namespace selvage::reports {
namespace {

[[nodiscard]] bool is_near(const spec::Rational& texel) {
  constexpr double kNear_texel = 0x1p-13;
  const spec::Rational above = texel - spec::floor(texel);
  return above < kNear_texel || above > 1 - kNear_texel;
}

struct Count {
  int64_t samples = 0, near = 0;
};

void count_row(const Polygon& polygon, int32_t row, Count* count) {
  for (int32_t px = 0; px < kMapWidth_px; ++px) {
    const auto sample = spec::sample(polygon, px, row);
    if (!sample) continue;
    ++count->samples;
    count->near += is_near(sample->u) || is_near(sample->v) ? 1 : 0;
  }
}

// Without an approximation: by the exact model, of some rows.
TEST(NearTieMaps, HaveNearTiesWhereTheirOrdinaryTwinsHaveFew) {
  Count hard, ordinary;
  int maps = 0;
  for (uint64_t seed = 1; seed <= 150; ++seed) {
    const NearTieMap map = near_tie_map(seed);
    for (int32_t row = 3; row < kMapHeight_px; row += 50) {
      count_row(map.hard, row, &hard);
      count_row(map.ordinary[seed % 3], row, &ordinary);
    }
    ++maps;
  }
  EXPECT_GT(hard.samples, 50 * maps);
  EXPECT_EQ(hard.samples, ordinary.samples) << "the same outlines";
  EXPECT_GT(hard.near * 3, hard.samples) << "a third of all samples, at least";
  EXPECT_LT(ordinary.near * 20, ordinary.samples);
}

TEST(NearTieMaps, AreOfAllKindsAndTheSameAgain) {
  int triangles = 0, deep = 0, far = 0, at_edge = 0, wrapped = 0;
  constexpr int kMaps = 300;
  for (uint64_t seed = 1; seed <= kMaps; ++seed) {
    const NearTieMap map = near_tie_map(seed);
    EXPECT_EQ(map.description, near_tie_map(seed).description);
    triangles += map.hard.size() == 3 ? 1 : 0;
    deep += map.description.find("perspective") != std::string::npos ? 1 : 0;
    at_edge += map.description.find("edge") != std::string::npos ? 1 : 0;
    wrapped += map.address == SELVAGE_ADDRESS_WRAP ? 1 : 0;
    far += std::ranges::any_of(map.hard,
                               [](const selvage_vertex& vertex) {
                                 return vertex.y > 2 * kMapHeight_px * SELVAGE_SUBPIXELS;
                               })
               ? 1
               : 0;
  }
  for (const int kind : {triangles, deep, far, wrapped}) {
    EXPECT_GT(kind, kMaps / 20);
    EXPECT_LT(kind, kMaps / 2);
  }
  EXPECT_GT(at_edge, kMaps / 2);
  EXPECT_LT(at_edge, kMaps * 9 / 10);
}

// Whatever the times are: in order, and each map can be looked at again.
TEST(NearTieSearch, TellsTheWorstMaps) {
  int32_t ticks = 0;
  const NearTieSearch search = search_near_ties({40, 15}, SELVAGE_KERNEL_FASTEST, [&] { ++ticks; });
  EXPECT_EQ(ticks, 15);
  ASSERT_EQ(search.ratios.size(), 15u);
  EXPECT_TRUE(std::ranges::is_sorted(search.ratios));
  EXPECT_GT(search.ratios.front(), 0);
  EXPECT_EQ(search.above(0), 15u);
  EXPECT_EQ(search.above(search.ratios.back()), 0u);
  const double middle = search.ratios[7];
  EXPECT_EQ(search.above(middle),
            std::ranges::count_if(search.ratios, [&](double ratio) { return ratio > middle; }));
  ASSERT_EQ(search.worst.size(), NearTieSearch::kWorst);
  EXPECT_EQ(search.worst.front().ratio(), search.ratios.back());
  EXPECT_TRUE(std::ranges::is_sorted(search.worst, std::ranges::greater(), &TimedMap::ratio));
  for (const TimedMap& map : search.worst) {
    EXPECT_EQ(map.description, near_tie_map(map.seed).description);
    EXPECT_GT(map.hard_ns, 0);
  }
}

}  // namespace
}  // namespace selvage::reports
