#include "many/bands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "spec/random.h"

namespace selvage::many {
namespace {

TEST(Bands, CoverTheRowsWithoutGapOrOverlap) {
  for (const Rows rows :
       {Rows{0, 1}, Rows{0, 7}, Rows{3, 1027}, Rows{-100, 411}, Rows{5, 1 << 30}}) {
    for (size_t wanted = 1; wanted <= kMostBands / 2; ++wanted) {
      for (const int32_t least : {1, 8, 100}) {
        const Bands bands(rows, wanted, least);
        int32_t next = rows.first;
        for (size_t band = 0; band < bands.count(); ++band) {
          const Rows of = bands.rows(band);
          ASSERT_EQ(of.first, next);
          ASSERT_FALSE(of.empty());
          ASSERT_EQ(bands.band_of(of.first), band);
          ASSERT_EQ(bands.band_of(of.end - 1), band);
          if (band + 1 < bands.count()) {
            ASSERT_GE(of.count(), least);
          }
          next = of.end;
        }
        ASSERT_EQ(next, rows.end);
        ASSERT_LE(bands.count(), std::min(2 * wanted, kMostBands));
      }
    }
  }
}

TEST(Bands, AreAsManyAsWantedWhereRowsSuffice) {
  for (size_t wanted = 1; wanted <= kMostBands / 2; ++wanted) {
    EXPECT_GE(Bands({0, 1024}, wanted, 8).count(), wanted);
    EXPECT_EQ(Bands({0, 8}, wanted, 8).count(), 1U);
  }
}

// Which polygons reach a band, by looking at each.
[[nodiscard]] std::vector<uint32_t> by_looking(const std::vector<Rows>& polygons, Rows band) {
  std::vector<uint32_t> found;
  for (uint32_t i = 0; i < polygons.size(); ++i) {
    if (!polygons[i].within(band).empty()) found.push_back(i);
  }
  return found;
}

[[nodiscard]] std::vector<Rows> random_polygons(spec::Random& random, size_t count) {
  std::vector<Rows> polygons;
  while (polygons.size() < count) {
    const int32_t first = random.in(-50, 600);
    const int32_t most = random.pick({2, 30, 700});
    polygons.push_back({first, first + random.in(-1, most)});
  }
  return polygons;
}

TEST(BandIndex, ListsThePolygonsOfEachBandInOrder) {
  for (uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    spec::Random random(seed);
    const size_t count = static_cast<size_t>(random.in(0, 200));
    const std::vector<Rows> polygons = random_polygons(random, count);
    const int32_t top = random.in(0, 100);
    const Bands bands({top, top + random.in(1, 500)}, random.below(kMostBands / 2) + 1,
                      random.in(1, 20));
    std::vector<uint32_t> entries(count * kMostNodes);
    BandIndex index(bands, entries);
    const size_t runs = random.below(kMostRuns) + 1;
    const auto run_of = [&](size_t i) { return i * runs / count; };
    for (size_t i = 0; i < count; ++i) index.add(run_of(i), polygons[i]);
    index.end_adding();
    // Runs may list in any order, each its own from first to last.
    for (size_t run = runs; run-- > 0;) {
      for (size_t i = 0; i < count; ++i) {
        if (run_of(i) == run) index.list(run, static_cast<uint32_t>(i), polygons[i]);
      }
    }
    for (size_t band = 0; band < bands.count(); ++band) {
      std::vector<uint32_t> listed;
      BandIndex::Reader reader(index, band);
      for (uint32_t i; reader.next(&i);) listed.push_back(i);
      ASSERT_EQ(listed, by_looking(polygons, bands.rows(band))) << "band " << band;
    }
  }
}

TEST(BandIndex, ListsNoPolygonAtMoreNodesThanThereIsRoomFor) {
  const Bands bands({0, static_cast<int32_t>(kMostBands)}, kMostBands / 2, 1);
  ASSERT_EQ(bands.count(), kMostBands / 2);
  const Bands most({0, 63}, kMostBands / 2, 1);
  ASSERT_EQ(most.count(), 63U);
  size_t greatest = 0;
  for (int32_t first = 0; first < 63; ++first) {
    for (int32_t end = first + 1; end <= 63; ++end) {
      size_t nodes = 0;
      most.for_each_node({first, end}, [&](size_t node) {
        ++nodes;
        EXPECT_LT(node, 2 * kMostBands);
      });
      greatest = std::max(greatest, nodes);
    }
  }
  EXPECT_EQ(greatest, kMostNodes);
}

}  // namespace
}  // namespace selvage::many
