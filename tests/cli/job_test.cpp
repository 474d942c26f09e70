#include "cli/job.h"

#include <cmath>

#include "support.h"

namespace selvage::cli::test {
namespace {

[[nodiscard]] Job job_of(std::vector<std::vector<JobVertex>> polygons) {
  Job job;
  for (auto& vertices : polygons) job.emplace_back().vertices = std::move(vertices);
  return job;
}

TEST(Snap, PutsVerticesOnTheGrid) {
  const auto polygons = snap(job_of({{{1.5, -2, 0.25, 3, 1}, {0, 0, 0, 0, 1}, {1, 0, 0, 0, 1}}}));
  ASSERT_EQ(polygons.size(), 1u);
  ASSERT_EQ(polygons[0].size(), 3u);
  EXPECT_EQ(polygons[0][0].x, 384);
  EXPECT_EQ(polygons[0][0].y, -512);
  EXPECT_EQ(polygons[0][0].u, 16384);
  EXPECT_EQ(polygons[0][0].v, 3 * 65536);
  EXPECT_EQ(polygons[0][0].q, polygons[0][1].q);
}

TEST(Snap, SharesTheLeastWOfTheWholeJob) {
  const auto polygons = snap(job_of({{{0, 0, 0, 0, 4}, {1, 0, 0, 0, 8}, {0, 1, 0, 0, 4}},
                                     {{0, 0, 0, 0, 2}, {1, 0, 0, 0, 4}, {0, 1, 0, 0, 16}}}));
  EXPECT_EQ(polygons[0][0].q, SELVAGE_Q_MAX / 2);
  EXPECT_EQ(polygons[0][1].q, SELVAGE_Q_MAX / 4);
  EXPECT_EQ(polygons[1][0].q, SELVAGE_Q_MAX);
  EXPECT_EQ(polygons[1][1].q, polygons[0][0].q);
  EXPECT_EQ(polygons[1][2].q, SELVAGE_Q_MAX / 8);
}

TEST(Snap, NamesTheVertexThatIsOutOfRange) {
  const std::string far_off = error_of([] {
    static_cast<void>(snap(job_of({{{0, 0, 0, 0}, {40000, 7, 1, 2}, {0, 1, 0, 0}}})));
  });
  expect_contains(far_off, "vertex 2 (x 40000, y 7, u 1, v 2, w 1): ");
  expect_contains(far_off, selvage_status_text(SELVAGE_ERROR_SNAP_POSITION));
  const std::string texture = error_of([] {
    static_cast<void>(snap(job_of({{{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}},
                                   {{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 50000}}})));
  });
  expect_contains(texture, "polygon 2, vertex 3 (x 0, y 1, u 0, v 50000, w 1): ");
  expect_contains(texture, selvage_status_text(SELVAGE_ERROR_SNAP_TEXTURE));
}

TEST(Snap, RefusesADistanceThatIsNone) {
  for (const double w : {0.0, -1.0, std::nan("")}) {
    const std::string error = error_of([&] {
      static_cast<void>(snap(job_of({{{0, 0, 0, 0, 1}, {1, 0, 0, 0, 2}, {0, 1, 0, 0, w}}})));
    });
    expect_contains(error, "vertex 3 ");
    expect_contains(error, "w is a distance, greater than 0");
  }
}

TEST(Snap, RefusesDistancesTooFarApart) {
  const std::string error = error_of([] {
    static_cast<void>(snap(job_of({{{0, 0, 0, 0, 1}, {1, 0, 0, 0, 1e9}, {0, 1, 0, 0, 1}}})));
  });
  expect_contains(error, "vertex 2 ");
  expect_contains(error, "w must be above 0, and at most 2^25 times the least w");
}

TEST(Options, HaveNames) {
  EXPECT_EQ(parse_address("clamp"), SELVAGE_ADDRESS_CLAMP);
  EXPECT_EQ(parse_address("wrap"), SELVAGE_ADDRESS_WRAP);
  EXPECT_EQ(parse_filter("nearest"), SELVAGE_FILTER_NEAREST);
  EXPECT_EQ(parse_filter("four"), SELVAGE_FILTER_FOUR);
  EXPECT_EQ(parse_filter("bilinear"), SELVAGE_FILTER_BILINEAR);
  EXPECT_EQ(parse_filter("area"), SELVAGE_FILTER_AREA);
  EXPECT_THROW(static_cast<void>(parse_filter("Area")), UserError);
  EXPECT_THROW(static_cast<void>(parse_address("Wrap")), UserError);
  EXPECT_THROW(static_cast<void>(parse_filter("")), UserError);
}

}  // namespace
}  // namespace selvage::cli::test
