#include "many/bands.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "many/band_index.h"
#include "many/band_work.h"
#include "spec/random.h"

namespace selvage::many {
namespace {

TEST(Bands, CoverTheRowsWithoutGapOrOverlap) {
  for (const Rows rows : {Rows{0, 1}, Rows{0, 7}, Rows{0, 8}, Rows{3, 1027}, Rows{3, 1028},
                          Rows{-100, 411}, Rows{5, 1 << 30}, Rows{0, INT32_MAX}}) {
    const Bands bands(rows);
    ASSERT_LE(bands.count(), kMostBands);
    int32_t next = rows.first;
    for (size_t band = 0; band < bands.count(); ++band) {
      const Rows of = bands.rows({band, band + 1});
      ASSERT_EQ(of.first, next);
      ASSERT_FALSE(of.empty());
      for (const int32_t row : {of.first, of.end - 1}) {
        const BandRange reached = bands.reached_by({row, row + 1});
        ASSERT_EQ(reached.first, band);
        ASSERT_EQ(reached.end, band + 1);
      }
      if (band + 1 < bands.count()) {
        ASSERT_GE(of.count(), kLeastBandRows);
      }
      next = of.end;
    }
    ASSERT_EQ(next, rows.end);
  }
}

TEST(Bands, AreAsManyAsCanBe) {
  EXPECT_EQ(Bands({0, 0}).count(), 0U);
  EXPECT_EQ(Bands({0, kLeastBandRows}).count(), 1U);
  EXPECT_EQ(Bands({0, kLeastBandRows + 1}).count(), 2U);
  EXPECT_EQ(Bands({0, 1024}).count(), 128U);
  EXPECT_EQ(Bands({0, 1025}).count(), 65U);
}

// Work of a few bands at random, and of one that has most of it. Some of it is so much that doubles
// round the sums.
[[nodiscard]] BandWork random_work(spec::Random& random) {
  BandWork work;
  for (int i = 0; i < 20; ++i) {
    const size_t first = random.below(kMostBands),
                 end = first + random.below(kMostBands - first) + 1;
    work.add({first, end}, std::ldexp(random.in(0, 1000), random.pick({0, 0, 60})));
  }
  const size_t most = random.below(kMostBands);
  work.add({most, most + 1}, random.pick({0, 1'000'000}));
  return work;
}

TEST(BandShares, HaveNoGapOrOverlap) {
  for (uint64_t seed = 1; seed <= 300; ++seed) {
    spec::Random random(seed);
    const BandWork work = seed == 1 ? BandWork() : random_work(random);
    const size_t first = random.below(kMostBands);
    const BandRange bands{first, first + random.below(kMostBands - first) + 1};
    const BandShares shares(work, bands);
    const size_t parts = random.below(bands.count()) + 1;
    size_t next = bands.first;
    for (size_t i = 0; i < parts; ++i) {
      const BandRange part = shares.part(i, parts);
      ASSERT_EQ(part.first, next) << "seed " << seed;
      ASSERT_GE(part.end, part.first);
      next = part.end;
    }
    ASSERT_EQ(next, bands.end);
  }
}

TEST(BandShares, HaveAboutTheSameWorkInEachPart) {
  BandWork work;
  work.add({0, 64}, 1);
  work.add({48, 64}, 2);
  work.add({0, 10}, 4);                              // 136
  const std::vector<size_t> ends = {7, 28, 53, 64};  // 35, 33, 35 and 33 of it
  const BandShares shares(work, {0, 64});
  EXPECT_EQ(shares.all_px(), 136);
  EXPECT_EQ(BandShares(work, {50, 60}).all_px(), 30);
  for (size_t i = 0; i < 4; ++i) EXPECT_EQ(shares.part(i, 4).end, ends[i]) << i;
}

// Which polygons reach some rows, from one on, by looking at each.
[[nodiscard]] std::vector<size_t> by_looking(const std::vector<Rows>& polygons, Rows rows,
                                             size_t first) {
  std::vector<size_t> found;
  for (size_t i = first; i < polygons.size(); ++i) {
    if (!polygons[i].within(rows).empty()) found.push_back(i);
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

[[nodiscard]] BandIndex::Group what_lay_there() {
  BandIndex::Group group;
  std::memset(&group, 0xFF, sizeof group);
  return group;
}

// Writers may write in any order, each its own groups from the first to the last.
void write(const BandIndex& index, const std::vector<Rows>& polygons, size_t polygons_each) {
  for (size_t end = polygons.size(); end > 0;) {
    const size_t first = (end - 1) / polygons_each * polygons_each;
    BandIndex::Writer writer(index, first);
    for (size_t i = first; i < end; ++i) {
      writer.add(index.bands().reached_by(polygons[i]));
    }
    writer.end();
    end = first;
  }
}

TEST(BandIndex, TellsThePolygonsOfBandsInOrder) {
  for (uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    spec::Random random(seed);
    const size_t count = static_cast<size_t>(random.pick({0, 1, 63, 64, 65, 128, 300}));
    const std::vector<Rows> polygons = random_polygons(random, count);
    const int32_t top = random.in(0, 100);
    std::vector<BandIndex::Group> groups(BandIndex::groups(count), what_lay_there());
    const BandIndex index(Bands({top, top + random.in(1, 1500)}), groups);
    write(index, polygons, BandIndex::kPolygonsPerGroup * (random.below(3) + 1));
    const size_t bands = index.bands().count(), parts = random.below(bands) + 1;
    for (size_t i = 0; i < parts; ++i) {
      const BandRange part{bands * i / parts, bands * (i + 1) / parts};
      const size_t from = random.pick({size_t{0}, random.below(count + 1), count});
      std::vector<size_t> told;
      BandIndex::Walk walk(index, part, from);
      for (size_t polygon; (polygon = walk.next()) != BandIndex::Walk::kEnd;) {
        told.push_back(polygon);
      }
      ASSERT_EQ(told, by_looking(polygons, index.bands().rows(part), from)) << "part " << i;
    }
  }
}

}  // namespace
}  // namespace selvage::many
