#include "many/workers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "many/runs.h"
#include "many/share_out.h"

namespace selvage::many {
namespace {

TEST(Workers, DoEachTaskOnce) {
  for (const size_t count : {0U, 1U, 2U, 7U, 64U, 1000U}) {
    for (const int32_t workers : {1, 2, 3, 8, 100}) {
      std::vector<int> done(count);
      share_out(count, workers, [&](size_t i) { ++done[i]; });
      EXPECT_EQ(done, std::vector<int>(count, 1)) << count << " tasks, " << workers << " workers";
    }
  }
}

TEST(Workers, MayShareOutWithinATask) {
  std::vector<std::vector<int>> done(4, std::vector<int>(50));
  share_out(done.size(), 4,
            [&](size_t i) { share_out(done[i].size(), 4, [&](size_t j) { ++done[i][j]; }); });
  for (const auto& row : done) EXPECT_EQ(row, std::vector<int>(50, 1));
}

TEST(Workers, AreAtLeastOne) {
  EXPECT_EQ(worker_count(1), 1);
  EXPECT_GE(worker_count(0), 1);
  EXPECT_GE(worker_count(3), 1);
  EXPECT_LE(worker_count(3), 3);
}

TEST(Runs, TileTheList) {
  for (const size_t count : {1U, 511U, 1023U, 1024U, 1025U, 5000U, 100'000U}) {
    for (const int32_t workers : {1, 4}) {
      const Runs runs(count, workers);
      ASSERT_LE(runs.count(), kMostRuns);
      EXPECT_EQ(runs.count() > 1, workers > 1 && count >= 1024) << count;
      EXPECT_TRUE(runs.count() == 1 || runs.count() >= 8) << count;  // for workers to have alike
      std::vector<int> seen(count);
      std::vector<size_t> begins(runs.count());
      runs.for_each([&](size_t run, size_t first, size_t end) {
        begins[run] = first;
        EXPECT_EQ(first % BandIndex::kPolygonsPerGroup, 0U);
        EXPECT_LT(first, end);
        for (size_t i = first; i < end; ++i) ++seen[i];
      });
      EXPECT_EQ(seen, std::vector<int>(count, 1));
      EXPECT_TRUE(std::is_sorted(begins.begin(), begins.end()));
    }
  }
}

}  // namespace
}  // namespace selvage::many
