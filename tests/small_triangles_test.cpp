// Small triangles, which kernels may draw several at a call: each kernel draws them as the scalar
// one does, one after another.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "mapper/image.h"
#include "mapper/polygon.h"
#include "mapper/small_triangles.h"
#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/any_surfaces.h"
#include "tests/fenced_bytes.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {
namespace {

using mapper::SmallLimits;
using mapper::SmallTriangles;
using spec::kPixel_fx8;
using spec::kTexel_fx16;

using SmallOutline = spec::Vertices;

[[nodiscard]] bool is_small_drawable(const SmallOutline& outline) {
  Polygon polygon;
  return examine(outline, &polygon) == SELVAGE_OK;
}

[[nodiscard]] const selvage_rect* clip_of(const spec::Case& c) {
  return c.has_clip ? &c.clip : nullptr;
}
[[nodiscard]] selvage_options options_for(const spec::Case& c, selvage_kernel kernel) {
  return {c.profile, c.filter, c.address, 0, kernel};
}

// As a case says, but of these outlines.
[[nodiscard]] spec::Canvas draw_each(const spec::Case& c, const selvage_texture& texture,
                                     const std::vector<SmallOutline>& outlines) {
  spec::Canvas target = target_of(c);
  const selvage_image image = target.image();
  const selvage_options options = options_for(c, SELVAGE_KERNEL_SCALAR);
  for (const SmallOutline& outline : outlines) {
    EXPECT_EQ(selvage_draw(&image, clip_of(c), outline.data(), outline.size(), &texture, &options),
              SELVAGE_OK);
  }
  return target;
}
[[nodiscard]] spec::Canvas draw_together(const spec::Case& c, const selvage_texture& texture,
                                         const std::vector<SmallOutline>& outlines,
                                         selvage_kernel kernel, int32_t threads) {
  spec::Canvas target = target_of(c);
  const selvage_image image = target.image();
  const selvage_options options = options_for(c, kernel);
  std::vector<selvage_polygon> polygons;
  for (const SmallOutline& outline : outlines) {
    polygons.push_back({outline.data(), outline.size(), &texture});
  }
  const size_t bytes = selvage_draw_many_bytes(polygons.size());
  std::vector<std::max_align_t> scratch(bytes / sizeof(std::max_align_t) + 1);
  EXPECT_EQ(selvage_draw_many(&image, clip_of(c), polygons.data(), polygons.size(), &options,
                              threads, scratch.data(), bytes, nullptr),
            SELVAGE_OK);
  return target;
}

void expect_list_drawn_alike(const spec::Case& c, const std::vector<SmallOutline>& outlines,
                             uint64_t seed) {
  const spec::TextureMemory texture = texture_of(c);
  const spec::Canvas one_by_one = draw_each(c, texture.view(), outlines);
  for (const selvage_kernel kernel : usable_kernels()) {
    for (const int32_t threads : {1, 3}) {
      ASSERT_TRUE(draw_together(c, texture.view(), outlines, kernel, threads) == one_by_one)
          << "kernel " << kernel << ", " << threads << " threads, seed " << seed << "\n"
          << spec::print(c);
    }
  }
}

[[nodiscard]] spec::Case any_small_case(spec::Random& random) {
  spec::Case c = any_surfaces(random);
  if (random.percent(10) && c.format == SELVAGE_RGBA8888) {
    c.filter = random.pick({SELVAGE_FILTER_BILINEAR, SELVAGE_FILTER_FOUR, SELVAGE_FILTER_AREA});
  }
  c.target_width_px = random.in(1, 60);
  c.target_height_px = random.in(1, 60);
  c.texture_width_texel = random.pick({1, 7, 8, 9, 15, 16, 17, 33, 100});
  c.texture_height_texel = random.pick({1, 3, 4, 7, 8, 9, 11, 12, 13, 33, 100});
  c.padding_px = random.in(0, 4);
  c.has_clip = random.percent(30);
  const int32_t left = random.in(-5, 50), top = random.in(-5, 50);
  c.clip = {left, top, left + random.in(1, 40), top + random.in(1, 40)};
  return c;
}

// b with a b = 1 modulo m, or 0 where there is none: Euclid's algorithm.
[[nodiscard]] int64_t inverse(int64_t a, int64_t m) {
  int64_t rest = m, other = a % m, factor = 0, other_factor = 1;
  while (other != 0) {
    const int64_t quotient = rest / other;
    std::swap(rest -= quotient * other, other);
    std::swap(factor -= quotient * other_factor, other_factor);
  }
  return rest == 1 ? (factor + m) % m : 0;
}

// Of hardly an area, so thin that u and v may run by more than lanes can tell: about a pixel's
// centre, the only point of the grid in it, or with one for a corner.
[[nodiscard]] SmallOutline any_needle(spec::Random& random, const spec::Case& c) {
  const int32_t x = random.in(0, c.target_width_px) * kPixel_fx8 + kPixel_fx8 / 2,
                y = random.in(0, c.target_height_px) * kPixel_fx8 + kPixel_fx8 / 2;
  const int32_t along = random.in(1, 8 * kPixel_fx8 - 2);
  const int32_t right = random.pick({1, -1}), down = random.pick({1, -1});
  SmallOutline needle{{-along, 1 - along, 0, 0, 1}, {-1, -1, 0, 0, 1}, {along + 1, along, 0, 0, 1}};
  const int32_t across = random.in(1, 8 * kPixel_fx8 - 2);
  const int64_t back = inverse(across, along);
  if (back != 0 && random.percent(50)) {
    const int64_t doubled_area = random.in(1, random.pick({4, 8, 8, 30}));
    const int64_t dy = doubled_area * back % along, dx = (across * dy - doubled_area) / along;
    needle = {{0, 0, 0, 0, 1},
              {across, along, 0, 0, 1},
              {static_cast<int32_t>(dx) - across, static_cast<int32_t>(dy) - along, 0, 0, 1}};
  }
  for (selvage_vertex& vertex : needle) {
    vertex.x = x + right * vertex.x;
    vertex.y = y + down * vertex.y;
  }
  return needle;
}

// Up to the greatest that may be small, and a little beyond; on pixels' centres or anywhere.
[[nodiscard]] SmallOutline any_small_outline(spec::Random& random, const spec::Case& c) {
  const int32_t most_px = random.pick({1, 3, 8, 16, 17});
  const int32_t x = random.in(-4, c.target_width_px) * kPixel_fx8 + random.pick({0, 128}),
                y = random.in(-4, c.target_height_px) * kPixel_fx8 + random.pick({0, 128});
  const int32_t grid_fx8 = random.pick({1, 1, kPixel_fx8 / 2, kPixel_fx8});
  SmallOutline triangle(3);
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
// beginning of a texel, so that many pixels are near-ties; or the pixels' own, scaled; or one that
// is the beginning of a texel along an edge, and nowhere less.
void set_any_texels(spec::Random& random, int32_t size_texel, int32_t selvage_vertex::*place,
                    int32_t selvage_vertex::*texel, SmallOutline* outline) {
  const int32_t most_texel = random.pick({1, 2, 4, 5, 8, 9, 12, 16, 20, 64, 70});
  const int32_t first = random.percent(80) ? random.in(0, std::max(1, size_texel - most_texel + 1))
                                           : random.in(-3, size_texel + 3);
  const int32_t from_fx16 = first * kTexel_fx16;
  const int32_t kind = random.in(0, 5), steepest = random.pick({128, 512, 2000});
  const int32_t per_px = random.in(-steepest, steepest + 1);
  const int32_t divisor = random.pick({1, 3, 5, 7});
  const size_t raised = random.below(outline->size());
  const int32_t first_fx8 = outline->front().*place;
  for (size_t i = 0; i < outline->size(); ++i) {
    selvage_vertex& vertex = (*outline)[i];
    int32_t& value = vertex.*texel;
    value = from_fx16;
    if (kind == 0) value += random.in(0, most_texel * kTexel_fx16);
    if (kind == 1) value += kTexel_fx16 - random.in(0, 3);
    if (kind == 2) value += random.in(0, most_texel) * kTexel_fx16;
    if (kind == 3) value += (vertex.*place - first_fx8) * per_px / divisor;
    if (kind == 4 && i == raised) {
      value += random.in(0, std::min(most_texel, size_texel) * kTexel_fx16);
    }
  }
}

// A parallelogram of a triangle, so that both lie in one plane.
void add_fourth(SmallOutline* outline) {
  const selvage_vertex &a = (*outline)[0], &b = (*outline)[1], &c = (*outline)[2];
  outline->push_back({a.x - b.x + c.x, a.y - b.y + c.y, a.u - b.u + c.u, a.v - b.v + c.v, 1});
}

[[nodiscard]] std::vector<SmallOutline> any_small_outlines(spec::Random& random,
                                                           const spec::Case& c) {
  std::vector<SmallOutline> outlines(static_cast<size_t>(random.in(1, 40)));
  for (SmallOutline& outline : outlines) {
    do {
      outline = random.percent(15) ? any_needle(random, c) : any_small_outline(random, c);
      set_any_texels(random, c.texture_width_texel, &selvage_vertex::x, &selvage_vertex::u,
                     &outline);
      set_any_texels(random, c.texture_height_texel, &selvage_vertex::y, &selvage_vertex::v,
                     &outline);
      if (random.percent(10)) add_fourth(&outline);
    } while (!is_small_drawable(outline));
    const int32_t q = random.pick({1, 1, 1000});
    for (selvage_vertex& vertex : outline) vertex.q = q;
    if (random.percent(5)) outline[1].q = 7;
  }
  return outlines;
}

// A block of seeds.
class SmallTrianglesOf : public testing::TestWithParam<uint64_t> {
 protected:
  static constexpr uint64_t kSeeds = 8000;
};

TEST_P(SmallTrianglesOf, EveryKernelDrawsAsTheScalarOneDoes) {
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    spec::Random random(seed);
    const spec::Case c = any_small_case(random);
    ASSERT_NO_FATAL_FAILURE(expect_list_drawn_alike(c, any_small_outlines(random, c), seed));
  }
}

INSTANTIATE_TEST_SUITE_P(Block, SmallTrianglesOf, testing::Range(uint64_t{0}, uint64_t{5}));

// How much of each vertex a point of a triangle has, times the doubled area: all of them positive
// inside.
struct Weights {
  int64_t of[3];

  [[nodiscard]] int64_t sum() const { return of[0] + of[1] + of[2]; }
  [[nodiscard]] bool are_inside() const { return of[0] > 0 && of[1] > 0 && of[2] > 0; }
};

[[nodiscard]] Weights weights_at(const SmallOutline& triangle, int32_t x_fx8, int32_t y_fx8) {
  const auto doubled_area = [&](size_t from, size_t to) {
    const int64_t ax = triangle[from].x - x_fx8, ay = triangle[from].y - y_fx8;
    const int64_t bx = triangle[to].x - x_fx8, by = triangle[to].y - y_fx8;
    return ax * by - ay * bx;
  };
  Weights weights{{doubled_area(1, 2), doubled_area(2, 0), doubled_area(0, 1)}};
  if (weights.sum() < 0) {
    for (int64_t& weight : weights.of) weight = -weight;
  }
  return weights;
}

// Of the pixels inside some triangle of most of 16 x 16 of them: the first, the last, or another.
struct CoveredPixel {
  SmallOutline triangle;
  Weights weights;
};
[[nodiscard]] CoveredPixel any_covered_pixel(spec::Random& random) {
  const auto end = [&](bool far) { return (far ? 16 * kPixel_fx8 : 0) + random.in(-140, 141); };
  for (;;) {
    const size_t without = random.below(4);
    SmallOutline triangle;
    for (size_t corner = 0; corner < 4; ++corner) {
      if (corner == without) continue;
      const int32_t x = end(corner == 1 || corner == 2), y = end(corner >= 2);
      triangle.push_back({x, y, 0, 0, 1});
    }
    std::vector<Weights> inside;
    for (int32_t row = 0; row < 16; ++row) {
      for (int32_t px = 0; px < 16; ++px) {
        const Weights weights = weights_at(triangle, px * kPixel_fx8 + 128, row * kPixel_fx8 + 128);
        if (weights.are_inside()) inside.push_back(weights);
      }
    }
    if (inside.empty()) continue;
    const size_t any = random.below(inside.size());
    return {triangle, inside[random.pick({size_t{0}, inside.size() - 1, any})]};
  }
}

// Values at the vertices, within some texels, that are a whole texel at the pixel, but for so many
// units of 1 / (65536 D) texel, D being the doubled area. False where chance found none.
[[nodiscard]] bool set_near_whole(spec::Random& random, const Weights& weights, int64_t off,
                                  int32_t most_texel, int32_t selvage_vertex::*texel,
                                  SmallOutline* triangle) {
  const int64_t area = weights.sum(), back = inverse(weights.of[0] % area, area);
  const int64_t most_fx16 = int64_t{most_texel} * kTexel_fx16;
  for (int tries = 0; back != 0 && tries < 2000; ++tries) {
    const int64_t b = random.in(0, most_fx16), c = random.in(0, most_fx16);
    const int64_t others = weights.of[1] * b + weights.of[2] * c - off;
    // weight a = -others, modulo the area
    const int64_t missing = ((-others) % area + area) % area;
    const int64_t a = missing * back % area;
    if (a >= most_fx16) continue;
    const int64_t value_fx16 = (weights.of[0] * a + others) / area;
    const auto raise = static_cast<int32_t>(-value_fx16 & (kTexel_fx16 - 1));
    (*triangle)[0].*texel = static_cast<int32_t>(a) + raise;
    (*triangle)[1].*texel = static_cast<int32_t>(b) + raise;
    (*triangle)[2].*texel = static_cast<int32_t>(c) + raise;
    return true;
  }
  return false;
}

// At one pixel u or v is whole, or hardly more, or hardly less: as near as a lane may lie to it.
TEST_P(SmallTrianglesOf, AreExactNextToWholeTexels) {
  int drawn = 0;
  for (uint64_t seed = GetParam() * kSeeds + 1; seed <= (GetParam() + 1) * kSeeds; ++seed) {
    spec::Random random(seed);
    auto [triangle, weights] = any_covered_pixel(random);
    for (selvage_vertex& vertex : triangle) {
      const int32_t u = random.in(0, 4 * kTexel_fx16), v = random.in(0, 4 * kTexel_fx16);
      vertex.u = u;
      vertex.v = v;
    }
    const int64_t area = weights.sum();
    // Lanes lack up to 35 / 256 of a unit of u and v, and are no more than floors.
    const int64_t off =
        random.percent(50) ? random.in(0, 40 * area / 256) : -int64_t{random.in(0, 300)};
    const auto texel = random.pick({&selvage_vertex::u, &selvage_vertex::v});
    const int32_t most_texel = random.pick({7, 15, 60});
    if (!set_near_whole(random, weights, off, most_texel, texel, &triangle)) continue;
    spec::Case c = any_surfaces(random);
    c.target_width_px = c.target_height_px = 17;
    c.texture_width_texel = c.texture_height_texel = most_texel + 1;
    ++drawn;
    ASSERT_NO_FATAL_FAILURE(expect_list_drawn_alike(c, {triangle}, seed));
  }
  EXPECT_GT(drawn, static_cast<int>(kSeeds / 4));
}

// Found by search: lanes that lack as much as any do at a pixel where u or v is hardly more than
// whole, and the exact values of the first pixel hardly less.
TEST(SmallTriangles, AreExactWhereLanesLackMost) {
  const std::vector<SmallOutline> triangles = {
      {{4135, 4143, 225403, 185313, 1}, {4131, 36, 405398, 26674, 1}, {108, 4134, 9480, 189801, 1}},
      {{4122, 4015, 184408, 131171, 1},
       {3985, -18, 160973, 224116, 1},
       {34, 4157, 520201, 151711, 1}},
      {{4123, 4158, 456557, 201086, 1},
       {4113, 73, 479954, 359833, 1},
       {121, 4051, 485830, 258811, 1}},
      {{4214, 22, 449806, 55269, 1}, {4211, 4071, 330751, 364123, 1}, {33, 4057, 226323, 10945, 1}},
      {{46, 5, 284238, 402047, 1}, {-97, 4040, 498404, 299485, 1}, {3975, -75, 142465, 144732, 1}},
      {{-54, 4221, 335954, 524135, 1},
       {-44, 15, 514864, 47076, 1},
       {4056, -123, 302563, 165720, 1}}};
  spec::Case c;
  c.format = SELVAGE_INDEX8;
  c.target_width_px = c.target_height_px = 32;
  c.texture_width_texel = c.texture_height_texel = 8;
  for (const SmallOutline& triangle : triangles) {
    ASSERT_NO_FATAL_FAILURE(expect_list_drawn_alike(c, {triangle}, /*seed=*/0));
  }
}

// Found by search, too: needles of which the start alone, or a step alone, is more than lanes tell.
TEST(SmallTriangles, AreExactWhereOneNumberIsBeyondLanes) {
  const std::vector<SmallOutline> needles = {{{10368, 8064, 8004354, 111186, 1},
                                              {9935, 8289, 7973865, 111185, 1},
                                              {13501, 6436, 8107703, 111185, 1}},
                                             {{1152, 3968, 196606, 8006116, 1},
                                              {219, 4722, 262144, 8006115, 1},
                                              {1496, 3690, 262141, 8006114, 1}},
                                             {{7296, 4992, 1768252, 296520, 1},
                                              {6975, 4087, 1928731, 296518, 1},
                                              {8187, 7504, 1867101, 296518, 1}},
                                             {{9059, 3097, 196605, 2587648, 1},
                                              {9808, 6075, 131069, 3541760, 1},
                                              {9600, 5248, 196606, 3276800, 1}}};
  spec::Case c;
  c.target_width_px = c.target_height_px = 60;
  c.texture_width_texel = c.texture_height_texel = 130;
  for (const SmallOutline& needle : needles) {
    ASSERT_NO_FATAL_FAILURE(expect_list_drawn_alike(c, {needle}, /*seed=*/0));
  }
}

// Its first byte lies behind a page that may not be read, or its last byte before one.
TEST(SmallTriangles, ReadNoTexelBesideTheTexture) {
  for (uint64_t seed = 1; seed <= 4000; ++seed) {
    SCOPED_TRACE(seed);
    spec::Random random(seed);
    const spec::Case c = any_small_case(random);
    const std::vector<SmallOutline> outlines = any_small_outlines(random, c);
    const ptrdiff_t pitch = c.texture_width_texel * ptrdiff_t{bytes_per_pixel(c.format)};
    const auto bytes = static_cast<size_t>(pitch * c.texture_height_texel);
    const FencedBytes texels(bytes,
                             random.pick({FencedBytes::Side::kFirst, FencedBytes::Side::kLast}));
    std::memset(texels.first(), 0x3C, bytes);
    const ptrdiff_t last_row = c.flip_texture ? pitch * (c.texture_height_texel - 1) : 0;
    const selvage_texture texture{texels.first() + last_row,
                                  c.texture_width_texel,
                                  c.texture_height_texel,
                                  c.flip_texture ? -pitch : pitch,
                                  c.format,
                                  SELVAGE_LAYOUT_ROWS,
                                  nullptr};
    for (const selvage_kernel kernel : usable_kernels()) {
      static_cast<void>(draw_together(c, texture, outlines, kernel, 1));
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
