// Lanes of small polygons against quotients without error, at each pixel inside one:
//
//     lane <= true value < lane + lack
//
// and none beyond the texture.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "mapper/draw.h"
#include "mapper/number.h"
#include "mapper/polygon.h"
#include "mapper/small_polygons.h"
#include "spec/random.h"
#include "tests/any_small_polygons.h"
#include "tests/vector/small_lanes.h"

namespace selvage::mapper {
namespace {

// A list of what kernels take of some outlines, to which it refers.
struct TakenPolygons {
  std::vector<Polygon> polygons;
  SmallPolygons small;
  std::vector<selvage_rect> parts;

  TakenPolygons(const std::vector<SmallOutline>& outlines, const selvage_texture& texture,
                selvage_address address, const selvage_rect& visible) {
    polygons.reserve(outlines.size());
    for (const SmallOutline& outline : outlines) {
      Polygon polygon;
      if (examine(outline, &polygon) != SELVAGE_OK) continue;
      const selvage_rect part = part_of(polygon, visible);
      if (is_empty(part) || !SmallPolygons::take(polygon, SmallEnds(texture, address), kSmall)) {
        continue;
      }
      if (!small.has_room_for(polygon)) return;
      polygons.push_back(polygon);
      parts.push_back(part);
      small.add(polygons.back(), part);
    }
  }
};

[[nodiscard]] Weights weights_of(const Polygon& polygon, int32_t column, int32_t row) {
  return weights_at(polygon.vertices, centre_fx8(column), centre_fx8(row));
}

// Whether it is in the polygon, or on an edge of what has an area: a parallelogram's second vertex
// lies between the other two.
[[nodiscard]] bool touch(const Polygon& polygon, const Weights& weights) {
  if (polygon.vertices.size() == 3) return weights.touch();
  const auto is_part = [&](int64_t weight) { return weight >= 0 && weight <= weights.sum(); };
  return weights.sum() > 0 && is_part(weights.of[0]) && is_part(weights.of[2]);
}

// u or v of a pixel, counted from a texel: n 2^-24 over d.
struct Quotient24 {
  int128 n = 0, d = 0;

  Quotient24(const Polygon& polygon, const Weights& weights, int32_t selvage_vertex::*of,
             int32_t from_texel) {
    for (size_t i = 0; i < 3; ++i) {
      const selvage_vertex& vertex = polygon.vertices[i];
      const int64_t value_fx16 = vertex.*of - (int64_t{from_texel} << kTexelFraction);
      const int128 part = int128{weights.of[i]} * vertex.q;
      n += part * (value_fx16 << (kWindowFraction - kTexelFraction));
      d += part;
    }
  }

  [[nodiscard]] bool is_told_by(int32_t lane_fx24, int32_t lack_fx24) const {
    return lane_fx24 * d <= n && n < (int64_t{lane_fx24} + lack_fx24) * d;
  }
  // How far it is from the middle of what it may be, a lack being from -1 to 1.
  [[nodiscard]] double part_of_lack(int32_t lane_fx24, int32_t lack_fx24) const {
    const int128 twice_off = 2 * (n - lane_fx24 * d) - lack_fx24 * d;
    return static_cast<double>(twice_off) / (static_cast<double>(d) * lack_fx24);
  }
};

struct Seen {
  int64_t pixels = 0, pixels_of_four = 0;
  int64_t large = 0, large_without = 0;  // of half a pixel or more, and without lanes
  double largest_part = 0;  // of what is allowed, either way, where that is more than truncation
};

class SmallLanesOfKernels : public testing::TestWithParam<uint64_t> {
 protected:
  static constexpr uint64_t kSeeds = 16000;

  // Begins of rows, and for pixels of which the polygon has no more: 0.
  [[nodiscard]] static SmallBegins begins_of(const Polygon& polygon, const selvage_rect& part) {
    SmallBegins begins{};
    for (int32_t row = part.top; row < part.bottom; ++row) {
      int32_t column = part.left;
      while (column < part.right && !touch(polygon, weights_of(polygon, column, row))) ++column;
      if (column < part.right) begins[static_cast<size_t>(row - part.top)] = column - part.left;
    }
    return begins;
  }
  static void expect_told(const Polygon& polygon, const selvage_rect& part,
                          const selvage_texture& texture, const SmallBegins& begins,
                          const SmallLanes& lanes, Seen* seen) {
    for (int32_t row = part.top; row < part.bottom; ++row) {
      const auto k = static_cast<size_t>(row - part.top);
      for (int32_t column = part.left + begins[k]; column < part.right; ++column) {
        const Weights weights = weights_of(polygon, column, row);
        if (!touch(polygon, weights)) continue;
        const auto px = static_cast<size_t>(column - part.left - begins[k]);
        const Quotient24 u(polygon, weights, &selvage_vertex::u, lanes.s_texel),
            v(polygon, weights, &selvage_vertex::v, lanes.t_texel);
        ASSERT_TRUE(u.is_told_by(lanes.u_fx24[k][px], lanes.lack_fx24)) << column << ", " << row;
        ASSERT_TRUE(v.is_told_by(lanes.v_fx24[k][px], lanes.lack_fx24)) << column << ", " << row;
        const int64_t s = lanes.s_texel + (lanes.u_fx24[k][px] >> kWindowFraction),
                      t = lanes.t_texel + (lanes.v_fx24[k][px] >> kWindowFraction);
        ASSERT_TRUE(s < texture.width && t < texture.height) << column << ", " << row;
        ++seen->pixels;
        seen->pixels_of_four += polygon.vertices.size() == 4;
        if (lanes.lack_fx24 < 100) continue;
        for (const double part_of_lack : {u.part_of_lack(lanes.u_fx24[k][px], lanes.lack_fx24),
                                          v.part_of_lack(lanes.v_fx24[k][px], lanes.lack_fx24)}) {
          seen->largest_part = std::max(seen->largest_part, std::abs(part_of_lack));
        }
      }
    }
  }
  static void expect_lanes(const SmallLanesOf& by, const spec::Case& c, const TakenPolygons& taken,
                           const selvage_texture& texture, Seen* seen) {
    std::vector<SmallBegins> begins;
    for (size_t i = 0; i < taken.polygons.size(); ++i) {
      begins.push_back(begins_of(taken.polygons[i], taken.parts[i]));
    }
    std::vector<SmallLanes> lanes(begins.size());
    by.find(taken.small, texture, begins, lanes);
    for (size_t i = 0; i < lanes.size(); ++i) {
      const selvage_rect& part = taken.parts[i];
      const bool large = weights_of(taken.polygons[i], part.left, part.top).sum() >= 1 << 16;
      seen->large += large;
      seen->large_without += large && !lanes[i].has_lanes;
      if (!lanes[i].has_lanes) continue;
      ASSERT_NO_FATAL_FAILURE(
          expect_told(taken.polygons[i], taken.parts[i], texture, begins[i], lanes[i], seen))
          << "polygon " << i << ", kernel " << by.kernel << "\n"
          << spec::print(c);
    }
  }
};

TEST_P(SmallLanesOfKernels, LackNoMoreThanTheySay) {
  if (all_small_lanes().empty()) GTEST_SKIP() << "no kernel here draws small polygons";
  for (const SmallLanesOf& by : all_small_lanes()) {
    Seen seen;
    for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
      SCOPED_TRACE(seed);
      spec::Random random(seed);
      const spec::Case c = any_small_case(random);
      const std::vector<SmallOutline> outlines = any_small_outlines(random, c);
      const spec::TextureMemory texture = texture_of(c);
      const selvage_rect visible = visible_rect(target_of(c).image(), clip_of(c));
      const TakenPolygons taken(outlines, texture.view(), c.address, visible);
      if (taken.polygons.empty()) continue;
      ASSERT_NO_FATAL_FAILURE(expect_lanes(by, c, taken, texture.view(), &seen));
    }
    // Or else lanes that say nothing would be told by nothing.
    EXPECT_GT(seen.pixels, 100'000) << "kernel " << by.kernel;
    EXPECT_GT(seen.pixels_of_four, 3'000) << "kernel " << by.kernel;
    EXPECT_LT(50 * seen.large_without, seen.large) << "kernel " << by.kernel;
    EXPECT_GT(seen.largest_part, 0.1) << "kernel " << by.kernel;
  }
}

INSTANTIATE_TEST_SUITE_P(Block, SmallLanesOfKernels, testing::Range(uint64_t{0}, uint64_t{4}));

}  // namespace
}  // namespace selvage::mapper
