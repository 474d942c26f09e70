#include "mapper/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "spec/exact.h"
#include "spec/generate.h"
#include "spec/vertex_units.h"
#include "tests/vertex.h"

namespace selvage::mapper {
namespace {

using spec::kTexel_fx16;

TEST(Polygon, TellsTopRowsAndAffinity) {
  const std::vector<selvage_vertex> v = {vertex(0, 300), vertex(500, -129), vertex(200, 640)};
  Polygon polygon;
  ASSERT_EQ(examine(v, &polygon), SELVAGE_OK);
  EXPECT_EQ(polygon.top, 1U);
  EXPECT_EQ(polygon.top_row, -1);
  EXPECT_EQ(polygon.bottom_row, 2);  // the centre at 640 is row 2's, and is not below the bottom
  EXPECT_TRUE(polygon.affine);
  const std::vector<selvage_vertex> w = {vertex(0, 300), vertex(500, -129, 2), vertex(200, 640)};
  ASSERT_EQ(examine(w, &polygon), SELVAGE_OK);
  EXPECT_FALSE(polygon.affine);
}

TEST(Polygon, RefusesWhatIsOutOfRange) {
  Polygon polygon;
  const auto status = [&](selvage_vertex odd) {
    return examine(std::vector{vertex(0, 0), vertex(9, 0), odd}, &polygon);
  };
  EXPECT_EQ(status(vertex(SELVAGE_X_MIN, SELVAGE_X_END - 1)), SELVAGE_OK);
  EXPECT_EQ(status(vertex(SELVAGE_X_MIN - 1, 5)), SELVAGE_ERROR_VERTEX_POSITION);
  EXPECT_EQ(status(vertex(5, SELVAGE_X_END)), SELVAGE_ERROR_VERTEX_POSITION);
  EXPECT_EQ(status(vertex(5, 5, 0)), SELVAGE_ERROR_VERTEX_Q);
  EXPECT_EQ(status(vertex(SELVAGE_X_MIN, SELVAGE_X_END - 1, 0)), SELVAGE_ERROR_VERTEX_Q);
  EXPECT_EQ(status(vertex(5, 5, SELVAGE_Q_MAX)), SELVAGE_OK);
  EXPECT_EQ(status(vertex(5, 5, SELVAGE_Q_MAX + 1)), SELVAGE_ERROR_VERTEX_Q);
  EXPECT_EQ(examine(std::vector{vertex(0, 0), vertex(9, 9)}, &polygon), SELVAGE_ERROR_VERTEX_COUNT);
}

TEST(Polygon, AcceptsLedgesAndRepeatedVerticesButNoSecondDescent) {
  Polygon polygon;
  const std::vector ledges = {vertex(0, 0),  vertex(9, 0),  vertex(9, 5),
                              vertex(12, 5), vertex(12, 5), vertex(12, 9),
                              vertex(-3, 9), vertex(0, 4),  vertex(0, 4)};
  EXPECT_EQ(examine(ledges, &polygon), SELVAGE_OK);
  const std::vector flat = {vertex(0, 7), vertex(9, 7), vertex(4, 7)};
  EXPECT_EQ(examine(flat, &polygon), SELVAGE_OK);
  EXPECT_EQ(polygon.top_row, polygon.bottom_row);
  const std::vector zigzag = {vertex(0, 0), vertex(4, 9), vertex(8, 3), vertex(12, 9)};
  EXPECT_EQ(examine(zigzag, &polygon), SELVAGE_ERROR_NOT_MONOTONE);
}

// Any number of any vertex; of several the first vertex's, and of it a place before q.
TEST(Polygon, RefusesEachNumberOutOfRange) {
  const std::vector<selvage_vertex> good = {{0, 0, 0, 0, 1}, {9, 0, 0, 0, 1}, {0, 9, 0, 0, 1}};
  Polygon polygon;
  ASSERT_EQ(examine(good, &polygon), SELVAGE_OK);
  const auto refusal = [&](size_t at, int32_t selvage_vertex::*number, int32_t value) {
    std::vector<selvage_vertex> bad = good;
    bad[at].*number = value;
    return examine(bad, &polygon);
  };
  for (size_t at = 0; at < good.size(); ++at) {
    for (const auto place : {&selvage_vertex::x, &selvage_vertex::y}) {
      EXPECT_EQ(refusal(at, place, SELVAGE_X_MIN - 1), SELVAGE_ERROR_VERTEX_POSITION);
      EXPECT_EQ(refusal(at, place, SELVAGE_X_END), SELVAGE_ERROR_VERTEX_POSITION);
    }
    EXPECT_EQ(refusal(at, &selvage_vertex::q, 0), SELVAGE_ERROR_VERTEX_Q);
    EXPECT_EQ(refusal(at, &selvage_vertex::q, SELVAGE_Q_MAX + 1), SELVAGE_ERROR_VERTEX_Q);
  }
  std::vector<selvage_vertex> bad = good;
  bad[1].q = 0;
  bad[2].y = SELVAGE_X_END;
  EXPECT_EQ(examine(bad, &polygon), SELVAGE_ERROR_VERTEX_Q);
  bad[1].x = SELVAGE_X_END;
  EXPECT_EQ(examine(bad, &polygon), SELVAGE_ERROR_VERTEX_POSITION);
}

// Whichever vertex comes first.
TEST(Polygon, TellsItsExtents) {
  std::vector<selvage_vertex> v = {
      {-300, 0, 7, -5, 9}, {128, -129, 70, 9, 4}, {1000, 640, 70, 90, 9}, {129, 641, -6, 90, 5}};
  for (size_t turn = 0; turn < 2 * v.size(); ++turn) {
    if (turn == v.size()) {
      for (selvage_vertex& each : v) std::swap(each.u, each.v);
    }
    Polygon polygon;
    ASSERT_EQ(examine(v, &polygon), SELVAGE_OK);
    EXPECT_EQ(v[polygon.top].y, -129);
    EXPECT_EQ(polygon.top_row, -1);
    EXPECT_EQ(polygon.bottom_row, 3);
    EXPECT_EQ(polygon.left_px, -1);
    EXPECT_EQ(polygon.right_px, 4);
    const auto& [least_u, least_v, most_u, most_v] = polygon.texels;
    const auto [u, u_end] = std::ranges::minmax(v, {}, &selvage_vertex::u);
    const auto [w, w_end] = std::ranges::minmax(v, {}, &selvage_vertex::v);
    EXPECT_EQ(std::tuple(least_u, most_u), std::tuple(u.u, u_end.u));
    EXPECT_EQ(std::tuple(least_v, most_v), std::tuple(w.v, w_end.v));
    EXPECT_EQ(std::min(least_u, least_v), -6);
    EXPECT_EQ(polygon.least_q, 4);
    EXPECT_FALSE(polygon.affine);
    std::ranges::rotate(v, v.begin() + 1);
  }
}

TEST(TexelBox, IsAsFarFromZeroAsItsFurthestSide) {
  EXPECT_EQ((TexelBox{-9, -2, 3, 4}).furthest_fx16(), 9);
  EXPECT_EQ((TexelBox{-2, -9, 3, 4}).furthest_fx16(), 9);
  EXPECT_EQ((TexelBox{1, 2, 9, 4}).furthest_fx16(), 9);
  EXPECT_EQ((TexelBox{1, 2, 3, 9}).furthest_fx16(), 9);
  EXPECT_EQ((TexelBox{-9, -9, -3, -4}).furthest_fx16(), 9);
  EXPECT_EQ((TexelBox{INT32_MIN, 0, INT32_MAX, 0}).furthest_fx16(), -int64_t{INT32_MIN});
}

TEST(Polygon, IsUntransformedByWholeTexelsAlone) {
  const auto shifted = [](int32_t u_fx16, int32_t v_fx16) {
    std::vector v = {vertex(-300, 0), vertex(500, -129), vertex(200, 640)};
    for (selvage_vertex& each : v) {
      each.u = each.x * 256 + u_fx16;
      each.v = each.y * 256 + v_fx16;
    }
    return v;
  };
  const auto is_untransformed = [](const std::vector<selvage_vertex>& v) {
    Polygon polygon;
    EXPECT_EQ(examine(v, &polygon), SELVAGE_OK);
    return polygon.untransformed;
  };
  const std::vector whole = shifted(3 * kTexel_fx16, -5 * kTexel_fx16);
  Polygon polygon;
  ASSERT_EQ(examine(whole, &polygon), SELVAGE_OK);
  EXPECT_TRUE(polygon.untransformed);
  EXPECT_EQ(polygon.ds, 3);
  EXPECT_EQ(polygon.dt, -5);
  for (const int32_t part : {1, 2, kTexel_fx16 / 2, kTexel_fx16 - 1}) {
    EXPECT_FALSE(is_untransformed(shifted(kTexel_fx16 + part, 0))) << part;
    EXPECT_FALSE(is_untransformed(shifted(0, kTexel_fx16 + part))) << part;
    EXPECT_FALSE(is_untransformed(shifted(part, part))) << part;
  }
  for (size_t i = 0; i < whole.size(); ++i) {
    for (int32_t selvage_vertex::*axis : {&selvage_vertex::u, &selvage_vertex::v}) {
      std::vector odd = whole;
      odd[i].*axis += kTexel_fx16;
      EXPECT_FALSE(is_untransformed(odd)) << i;
    }
    std::vector deep = whole;
    deep[i].q = 2;
    EXPECT_FALSE(is_untransformed(deep)) << i;
  }
}

// Two definitions of y-monotone, directions around the outline and lines through the vertices.
TEST(Polygon, AgreesWithTheSpecificationOnWhatIsMonotone) {
  int refused = 0;
  for (uint64_t seed = 1; seed <= 20000; ++seed) {
    const spec::Case c = spec::generate(seed);
    Polygon polygon;
    ASSERT_EQ(examine(c.vertices, &polygon), spec::validity(c.vertices)) << spec::print(c);
    refused += spec::validity(c.vertices) == SELVAGE_ERROR_NOT_MONOTONE ? 1 : 0;
  }
  EXPECT_GT(refused, 100);
}

// Half-open: of equal ends there is nothing between.
TEST(Polygon, HasAPartThatIsVisibleOrNone) {
  Polygon polygon;
  polygon.left_px = 2, polygon.top_row = 3, polygon.right_px = 7, polygon.bottom_row = 9;
  const auto expect_part = [&](const selvage_rect& visible, const selvage_rect& want) {
    const selvage_rect part = part_of(polygon, visible);
    EXPECT_EQ(part.left, want.left);
    EXPECT_EQ(part.top, want.top);
    EXPECT_EQ(part.right, want.right);
    EXPECT_EQ(part.bottom, want.bottom);
    return is_empty(part);
  };
  EXPECT_FALSE(expect_part({0, 0, 20, 20}, {2, 3, 7, 9}));
  EXPECT_FALSE(expect_part({3, 4, 5, 6}, {3, 4, 5, 6}));
  EXPECT_FALSE(expect_part({6, 8, 20, 20}, {6, 8, 7, 9}));
  EXPECT_TRUE(expect_part({7, 0, 20, 20}, {7, 3, 7, 9}));
  EXPECT_TRUE(expect_part({0, 0, 1, 20}, {2, 3, 1, 9}));
  EXPECT_TRUE(expect_part({0, 9, 20, 20}, {2, 9, 7, 9}));
  EXPECT_TRUE(expect_part({0, 0, 20, 1}, {2, 3, 7, 1}));
}

}  // namespace
}  // namespace selvage::mapper
