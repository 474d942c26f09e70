// That the inexact loops are worth comparing with: they draw what the model draws but for
// roundings, every one of them the same pixels, whichever way they fetch texels, and none beyond
// the texture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reports/bench/error_count.h"
#include "reports/bench/inexact_loops.h"
#include "reports/bench/outlines.h"
#include "support.h"

namespace selvage::reports::test {
namespace {

using Polygons = std::vector<std::vector<selvage_vertex>>;

Target drawn_by(const InexactLoop& loop, const Workload& load, const Texture& texture) {
  Target target(load.target_side_px, load.target_side_px);
  for (const auto& polygon : load.polygons)
    loop.draw(inexact_polygon(polygon, target.height_px), texture, target);
  return target;
}

// Wrong pixels of all kinds in a thousand, and no texel off by more than one.
void expect_nearly_exact(const Workload& load, const ModelRows& model, double most_per_mille) {
  const Texture texture(load.texture_side_texel);
  const std::vector<InexactLoop> loops = inexact_loops();
  ASSERT_FALSE(loops.empty());
  const Target first = drawn_by(loops.front(), load, texture);
  const ErrorCount errors = count_errors(model, first, true, SELVAGE_FILTER_NEAREST);
  ASSERT_GT(errors.covered_px, 0u);
  EXPECT_LE(static_cast<double>(errors.total()),
            most_per_mille / 1000 * static_cast<double>(errors.covered_px));
  EXPECT_LE(errors.largest_texel, 1);
  for (const InexactLoop& loop : loops)
    EXPECT_EQ(drawn_by(loop, load, texture).pixels, first.pixels) << load.id << ", " << loop.name;
}

ModelRows some_rows_of(const Workload& load, int32_t count) {
  return model_rows(load, sample_rows(load.target_side_px, count, 1), [] {});
}

TEST(InexactLoops, DrawTheWorkItemsAlmostExactly) {
  if (inexact_loops().empty()) GTEST_SKIP() << "no vector kernels here";
  for (const Workload& load : workloads(1)) {
    if (load.filter != SELVAGE_FILTER_NEAREST) continue;
    SCOPED_TRACE(load.id);
    expect_nearly_exact(load, some_rows_of(load, 16), 10);
  }
}

// Squares that show a piece of the texture and what is beyond it, turned all ways, from larger than
// a window of texels down to less than one.
TEST(InexactLoops, ClampOnEachSideInAllDirections) {
  if (inexact_loops().empty()) GTEST_SKIP() << "no vector kernels here";
  for (const int32_t side_texel : {16, 32, 64}) {
    for (const double texels_a_px : {0.05, 0.3, 0.9, 1.7, 5.0}) {
      for (int degree = 7; degree < 360; degree += 31) {
        Workload load;
        load.id = std::to_string(side_texel) + " texels, " + std::to_string(texels_a_px) +
                  " a pixel, " + std::to_string(degree) + " degrees";
        load.target_side_px = 64;
        load.texture_side_texel = side_texel;
        const double angle = degree * 3.14159265358979 / 180;
        const double cosine = std::cos(angle) * texels_a_px, sine = std::sin(angle) * texels_a_px;
        std::vector<selvage_vertex> polygon;
        for (const auto& [x, y] :
             {std::pair(2, 3), std::pair(61, 3), std::pair(61, 62), std::pair(2, 62)}) {
          const double dx = x - 31.3, dy = y - 32.4;
          polygon.push_back({x * 256, y * 256,
                             texel_to_fx16(side_texel / 2.0 + cosine * dx - sine * dy),
                             texel_to_fx16(side_texel / 2.0 + sine * dx + cosine * dy), 1});
        }
        // One triangle, so that vertices on the grid have one plane.
        load.polygons = {{polygon[0], polygon[1], polygon[3]}};
        SCOPED_TRACE(load.id);
        expect_nearly_exact(load, some_rows_of(load, 64), 20);
      }
    }
  }
}

TEST(InexactLoops, DrawPerspectiveInAllDirections) {
  if (inexact_loops().empty()) GTEST_SKIP() << "no vector kernels here";
  for (const int32_t side_texel : {16, 256}) {
    for (int turn = 0; turn < 3; ++turn) {
      for (const bool mirrored : {false, true}) {
        std::vector<selvage_vertex> corner{{5 * 256 + 31, 7 * 256 + 3, 0, 0, 1 << 20},
                                           {251 * 256 + 77, 40 * 256 + 9, 0, 0, 3 << 20},
                                           {90 * 256 + 120, 249 * 256 + 250, 0, 0, 2 << 20}};
        const int32_t end = texel_to_fx16(side_texel);
        for (size_t i = 0; i < 3; ++i) {
          selvage_vertex& vertex = corner[(i + static_cast<size_t>(turn)) % 3];
          vertex.u = i == 1 ? end : 0;
          vertex.v = i == 2 ? end : 0;
          if (mirrored) std::swap(vertex.u, vertex.v);
        }
        Workload load;
        load.id = "perspective";
        load.target_side_px = 256;
        load.texture_side_texel = side_texel;
        load.perspective = true;
        load.polygons = {corner};
        SCOPED_TRACE(std::to_string(side_texel) + " texels, corner " + std::to_string(turn));
        expect_nearly_exact(load, some_rows_of(load, 256), 10);
      }
    }
  }
}

TEST(InexactLoops, CopyARectangleTexelByTexel) {
  if (inexact_loops().empty()) GTEST_SKIP() << "no vector kernels here";
  const Workload load = small_workload({rectangle(2, 3, 29, 31, 0.25)});
  expect_nearly_exact(load, some_rows_of(load, 32), 0);
}

TEST(InexactSubject, IsMeasuredOnEachNearestItem) {
  const Subject subject = subject_inexact();
  const Plan plan = plan_of(small_workload({rectangle(2, 3, 10, 12)}), {subject});
  const auto results = measure(plan, quick_settings(), ignore_progress);
  const Cell& cell = results[0].cells[0];
  EXPECT_EQ(cell.refusal.empty(), !inexact_loops().empty());
  if (inexact_loops().empty()) return;
  EXPECT_EQ(cell.errors->total(), 0u);
  EXPECT_GT(cell.ns_per_px.median, 0);
}

TEST(InexactSubject, NamesTheLoopsThatItTries) {
  for (const InexactLoop& loop : inexact_loops())
    EXPECT_NE(subject_inexact().configuration.find(loop.name), std::string::npos) << loop.name;
  EXPECT_EQ(subjects_inexact_by_loop().size(), inexact_loops().size());
}

}  // namespace
}  // namespace selvage::reports::test
