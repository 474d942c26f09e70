// Generated cases reach the filters, and what is hard for each of them.
#include <gtest/gtest.h>

#include <algorithm>

#include "spec/generate.h"
#include "spec/generate_historic.h"
#include "spec/model.h"
#include "spec/picture.h"
#include "spec/profiles.h"

namespace selvage::spec {
namespace {

// Of pixels drawn with a filter.
struct Counts {
  int cases = 0, pixels = 0, perspective = 0, wrap = 0;
  int ties = 0;           // 256 (u - 1/2) or the same of v is a whole number
  int across_border = 0;  // some texel is addressed to another one
  int minified = 0, magnified = 0, long_boxes = 0, of_all_texels = 0;
};

[[nodiscard]] bool is_tie(const Rational& coordinate) {
  return Rational(256 * (coordinate - Rational(1, 2))).get_den() == 1;
}

[[nodiscard]] bool leaves(const Taps& taps, int32_t size) {
  return taps.front().texel < 0 || taps.back().texel >= size;
}

void count(const Case& c, int32_t x, int32_t y, const Sample& point, Counts* counts) {
  ++counts->pixels;
  counts->ties += is_tie(point.u) || is_tie(point.v);
  BoxSides sides;
  if (c.filter == SELVAGE_FILTER_AREA) sides = box_sides(gradient(c.vertices, x, y).value());
  const int32_t longer = std::max(sides.u_fx8, sides.v_fx8);
  const Taps columns = taps(c.filter, point.u, sides.u_fx8);
  counts->across_border += leaves(columns, c.texture_width_texel);
  counts->magnified += c.filter == SELVAGE_FILTER_AREA && longer == kLeastBoxSide_fx8;
  counts->minified += longer > kLeastBoxSide_fx8;
  counts->long_boxes += longer > 256 * 256;
  counts->of_all_texels += longer == kMostBoxSide_fx8;
}

TEST(GenerateFilters, InSaneShares) {
  constexpr int kCases = 4000;
  Counts counts;
  int by_filter[4] = {};
  for (uint64_t seed = 0; seed < kCases; ++seed) {
    const Case c = generate(seed);
    ++by_filter[c.filter];
    if (c.filter == SELVAGE_FILTER_NEAREST) continue;
    ASSERT_TRUE(can_be_filtered(c));
    ++counts.cases;
    if (validity(c) != SELVAGE_OK) continue;
    const auto differs = [&](const selvage_vertex& v) { return v.q != c.vertices[0].q; };
    counts.perspective += std::ranges::any_of(c.vertices, differs);
    counts.wrap += c.address == SELVAGE_ADDRESS_WRAP;
    for (int32_t y = 0; y < c.target_height_px; y += 2) {
      for (int32_t x = 0; x < c.target_width_px; x += 2) {
        if (const auto point = sample(c.vertices, x, y)) count(c, x, y, *point, &counts);
      }
    }
  }
  for (const int share : by_filter) EXPECT_GT(share, kCases / 12);
  EXPECT_GT(counts.cases, kCases / 4);
  EXPECT_GT(counts.perspective, counts.cases / 5);
  EXPECT_GT(counts.wrap, counts.cases / 4);
  EXPECT_GT(counts.ties, counts.pixels / 20);
  EXPECT_GT(counts.across_border, counts.pixels / 10);
  EXPECT_GT(counts.magnified, counts.pixels / 20);
  EXPECT_GT(counts.minified, counts.pixels / 20);
  EXPECT_GT(counts.long_boxes, counts.pixels / 100);
  EXPECT_GT(counts.of_all_texels, 10);
}

TEST(GenerateFilters, NotInHistoricProfiles) {
  for (const Profile& profile : profiles().subspan(1)) {
    for (uint64_t seed = 0; seed < 500; ++seed) {
      EXPECT_EQ(generate(seed, profile.id).filter, SELVAGE_FILTER_NEAREST);
    }
  }
}

}  // namespace
}  // namespace selvage::spec
