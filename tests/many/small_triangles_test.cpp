// Small triangles, which kernels may draw several at a call: each kernel draws them as the scalar
// one does, one after another.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mapper/kernel_choice.h"
#include "mapper/polygon.h"
#include "mapper/small_triangles.h"
#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/any_surfaces.h"
#include "tests/kernel_support.h"

namespace selvage::many {
namespace {

using mapper::SmallLimits;
using mapper::SmallTriangles;
using spec::kPixel_fx8;
using spec::kTexel_fx16;

using Triangle = std::array<selvage_vertex, 3>;

[[nodiscard]] bool is_drawable(const Triangle& triangle) {
  mapper::Polygon polygon;
  return mapper::examine(triangle, &polygon) == SELVAGE_OK;
}

// Of cases that differ in their vertices alone.
class Drawing {
 public:
  explicit Drawing(const spec::Case& c)
      : texture_(mapper::texture_of(c)), target_(mapper::target_of(c)), case_(c) {}

  void draw_each(const std::vector<Triangle>& triangles) {
    const selvage_options options = options_of(SELVAGE_KERNEL_SCALAR);
    const selvage_image image = target_.image();
    for (const Triangle& triangle : triangles) {
      EXPECT_EQ(selvage_draw(&image, clip(), triangle.data(), triangle.size(), &texture_.view(),
                             &options),
                SELVAGE_OK);
    }
  }
  void draw_together(const std::vector<Triangle>& triangles, selvage_kernel kernel,
                     int32_t threads) {
    const selvage_options options = options_of(kernel);
    const selvage_image image = target_.image();
    std::vector<selvage_polygon> polygons;
    for (const Triangle& triangle : triangles) {
      polygons.push_back({triangle.data(), triangle.size(), &texture_.view()});
    }
    const size_t bytes = selvage_draw_many_bytes(polygons.size());
    std::vector<std::max_align_t> scratch(bytes / sizeof(std::max_align_t) + 1);
    EXPECT_EQ(selvage_draw_many(&image, clip(), polygons.data(), polygons.size(), &options, threads,
                                scratch.data(), bytes, nullptr),
              SELVAGE_OK);
  }
  [[nodiscard]] const spec::Canvas& target() const { return target_; }

 private:
  [[nodiscard]] const selvage_rect* clip() const { return case_.has_clip ? &case_.clip : nullptr; }
  [[nodiscard]] selvage_options options_of(selvage_kernel kernel) const {
    return {case_.profile, case_.filter, case_.address, 0, kernel};
  }

  spec::TextureMemory texture_;
  spec::Canvas target_;
  spec::Case case_;
};

void expect_drawn_alike(const spec::Case& c, const std::vector<Triangle>& triangles,
                        uint64_t seed) {
  Drawing one_by_one(c);
  one_by_one.draw_each(triangles);
  for (const selvage_kernel kernel : mapper::usable_kernels()) {
    for (const int32_t threads : {1, 3}) {
      Drawing together(c);
      together.draw_together(triangles, kernel, threads);
      ASSERT_TRUE(together.target() == one_by_one.target())
          << "kernel " << kernel << ", " << threads << " threads, seed " << seed << "\n"
          << spec::print(c);
    }
  }
}

[[nodiscard]] spec::Case any_case(spec::Random& random) {
  spec::Case c = mapper::any_surfaces(random);
  if (random.percent(10) && c.format == SELVAGE_RGBA8888) {
    c.filter = random.pick({SELVAGE_FILTER_BILINEAR, SELVAGE_FILTER_FOUR, SELVAGE_FILTER_AREA});
  }
  c.target_width_px = random.in(1, 60);
  c.target_height_px = random.in(1, 60);
  c.texture_width_texel = random.pick({1, 7, 8, 9, 16, 33});
  c.texture_height_texel = random.pick({1, 4, 7, 8, 9, 33});
  c.padding_px = random.in(0, 4);
  c.has_clip = random.percent(30);
  const int32_t left = random.in(-5, 50), top = random.in(-5, 50);
  c.clip = {left, top, left + random.in(1, 40), top + random.in(1, 40)};
  return c;
}

// About a pixel's centre, the only point of the grid in it: so thin that u and v may run by more
// than lanes can tell.
[[nodiscard]] Triangle any_needle(spec::Random& random, const spec::Case& c) {
  const int32_t x = random.in(0, c.target_width_px) * kPixel_fx8 + kPixel_fx8 / 2,
                y = random.in(0, c.target_height_px) * kPixel_fx8 + kPixel_fx8 / 2;
  const int32_t along = random.in(1, 8 * kPixel_fx8 - 2);
  const int32_t right = random.pick({1, -1}), down = random.pick({1, -1});
  Triangle triangle{{{-along, 1 - along, 0, 0, 1}, {-1, -1, 0, 0, 1}, {along + 1, along, 0, 0, 1}}};
  for (selvage_vertex& vertex : triangle) {
    vertex.x = x + right * vertex.x;
    vertex.y = y + down * vertex.y;
  }
  return triangle;
}

// Up to the greatest that may be small, and a little beyond; on pixels' centres or anywhere.
[[nodiscard]] Triangle any_outline(spec::Random& random, const spec::Case& c) {
  const int32_t most_px = random.pick({1, 3, 8, 16, 17});
  const int32_t x = random.in(-4, c.target_width_px) * kPixel_fx8,
                y = random.in(-4, c.target_height_px) * kPixel_fx8;
  const int32_t grid_fx8 = random.pick({1, 1, kPixel_fx8 / 2, kPixel_fx8});
  Triangle triangle;
  for (selvage_vertex& vertex : triangle) {
    const auto near = [&](int32_t from_fx8) {
      const int32_t by_fx8 = random.in(0, most_px * kPixel_fx8 + 1);
      return from_fx8 + by_fx8 / grid_fx8 * grid_fx8;
    };
    vertex = {near(x), near(y), 0, 0, 1};
  }
  if (random.percent(10)) triangle[2].y = triangle[random.percent(50) ? 0 : 1].y;
  // Hardly an area, or none.
  if (random.percent(10)) {
    triangle[2].x = (triangle[0].x + triangle[1].x) / 2 + random.in(-1, 2);
    triangle[2].y = (triangle[0].y + triangle[1].y) / 2 + random.in(-1, 2);
  }
  return triangle;
}

// A coordinate anywhere in some texels of the texture or beside it; or what hardly leaves the
// beginning of a texel, so that many pixels are near-ties; or the pixels' own, scaled.
void set_texels(spec::Random& random, int32_t size_texel, int32_t selvage_vertex::*place,
                int32_t selvage_vertex::*texel, Triangle* triangle) {
  const int32_t most_texel = random.pick({1, 2, 4, 5, 8, 9, 20});
  const int32_t first = random.percent(80) ? random.in(0, std::max(1, size_texel - most_texel + 1))
                                           : random.in(-3, size_texel + 3);
  const int32_t from_fx16 = first * kTexel_fx16;
  const int32_t kind = random.in(0, 4), per_px = random.in(-128, 129);
  const int32_t divisor = random.pick({1, 3, 5, 7});
  for (selvage_vertex& vertex : *triangle) {
    int32_t& value = vertex.*texel;
    if (kind == 0) value = from_fx16 + random.in(0, most_texel * kTexel_fx16);
    if (kind == 1) value = from_fx16 + kTexel_fx16 - random.in(0, 3);
    if (kind == 2) value = from_fx16 + random.in(0, most_texel) * kTexel_fx16;
    if (kind == 3) value = from_fx16 + (vertex.*place - (*triangle)[0].*place) * per_px / divisor;
  }
}

[[nodiscard]] std::vector<Triangle> any_triangles(spec::Random& random, const spec::Case& c) {
  std::vector<Triangle> triangles(static_cast<size_t>(random.in(1, 40)));
  for (Triangle& triangle : triangles) {
    do {
      triangle = random.percent(5) ? any_needle(random, c) : any_outline(random, c);
      set_texels(random, c.texture_width_texel, &selvage_vertex::x, &selvage_vertex::u, &triangle);
      set_texels(random, c.texture_height_texel, &selvage_vertex::y, &selvage_vertex::v, &triangle);
    } while (!is_drawable(triangle));
    const int32_t q = random.pick({1, 1, 1000});
    for (selvage_vertex& vertex : triangle) vertex.q = q;
    if (random.percent(5)) triangle[1].q = 7;
  }
  return triangles;
}

// A block of seeds.
class SmallTrianglesOf : public testing::TestWithParam<uint64_t> {
 protected:
  static constexpr uint64_t kSeeds = 2000;
};

TEST_P(SmallTrianglesOf, EveryKernelDrawsAsTheScalarOneDoes) {
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    spec::Random random(seed);
    const spec::Case c = any_case(random);
    ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(c, any_triangles(random, c), seed));
  }
}

INSTANTIATE_TEST_SUITE_P(Block, SmallTrianglesOf, testing::Range(uint64_t{0}, uint64_t{5}));

// What is taken: by limits of 16 px and 8 x 4 texels from a texture of 20 x 10.
class Taken : public testing::Test {
 protected:
  static constexpr SmallLimits kLimits{16, 8, 4};

  [[nodiscard]] static bool takes(const Triangle& triangle) {
    static constexpr uint8_t kTexels[200] = {};
    const selvage_texture texture{kTexels, 20, 10, 20, SELVAGE_INDEX8, SELVAGE_LAYOUT_ROWS,
                                  nullptr};
    mapper::Polygon polygon;
    EXPECT_EQ(mapper::examine(triangle, &polygon), SELVAGE_OK);
    return SmallTriangles::take(polygon, texture, kLimits);
  }
  // All limits are met by less than a unit.
  static constexpr Triangle kLargest{{{-127, -127, 12 << 16, 6 << 16, 1},
                                      {128 + 16 * 256, 300, (20 << 16) - 1, 6 << 16, 1},
                                      {400, 128 + 16 * 256, 13 << 16, (10 << 16) - 1, 1}}};
};

TEST_F(Taken, IsWhatMeetsTheLimits) {
  EXPECT_TRUE(takes(kLargest));
  Triangle other = kLargest;
  for (selvage_vertex& vertex : other) vertex.q = 5;
  EXPECT_TRUE(takes(other));
}

TEST_F(Taken, IsNotWhatExceedsOne) {
  const auto expect_left = [](size_t vertex, int32_t selvage_vertex::*of, int32_t by) {
    Triangle other = kLargest;
    other[vertex].*of += by;
    EXPECT_FALSE(takes(other)) << "vertex " << vertex << " by " << by;
  };
  expect_left(0, &selvage_vertex::x, -1);
  expect_left(1, &selvage_vertex::x, 1);
  expect_left(0, &selvage_vertex::y, -1);
  expect_left(2, &selvage_vertex::y, 1);
  expect_left(0, &selvage_vertex::u, -1);
  expect_left(1, &selvage_vertex::u, 1);
  expect_left(0, &selvage_vertex::v, -1);
  expect_left(2, &selvage_vertex::v, 1);
  expect_left(1, &selvage_vertex::q, 1);
}

TEST_F(Taken, LiesInTheTexture) {
  const auto moved = [](int32_t selvage_vertex::*of, int32_t by) {
    Triangle triangle = kLargest;
    for (selvage_vertex& vertex : triangle) vertex.*of += by;
    return triangle;
  };
  EXPECT_TRUE(takes(moved(&selvage_vertex::u, -(12 << 16))));
  EXPECT_FALSE(takes(moved(&selvage_vertex::u, -(13 << 16))));
  EXPECT_FALSE(takes(moved(&selvage_vertex::u, 1 << 16)));
  EXPECT_TRUE(takes(moved(&selvage_vertex::v, -(6 << 16))));
  EXPECT_FALSE(takes(moved(&selvage_vertex::v, -(7 << 16))));
  EXPECT_FALSE(takes(moved(&selvage_vertex::v, 1 << 16)));
}

TEST_F(Taken, IsFromTexturesOfRowsThatHoldAWindow) {
  const auto from = [](int32_t width, int32_t height, selvage_layout layout) {
    return SmallTriangles::take_from(
        {nullptr, width, height, width, SELVAGE_INDEX8, layout, nullptr}, kLimits);
  };
  EXPECT_TRUE(from(8, 4, SELVAGE_LAYOUT_ROWS));
  EXPECT_FALSE(from(7, 4, SELVAGE_LAYOUT_ROWS));
  EXPECT_FALSE(from(8, 3, SELVAGE_LAYOUT_ROWS));
  EXPECT_FALSE(from(8, 8, SELVAGE_LAYOUT_TILES));
  EXPECT_FALSE(SmallTriangles::take_from(
      {nullptr, 8, 8, 8, SELVAGE_INDEX8, SELVAGE_LAYOUT_ROWS, nullptr}, SmallLimits{}));
}

}  // namespace
}  // namespace selvage::many
