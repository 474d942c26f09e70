// Small triangles, which kernels may draw several at a call: each kernel draws them as the scalar
// one does, one after another.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <vector>

#include "mapper/image.h"
#include "mapper/polygon.h"
#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/any_surfaces.h"
#include "tests/fenced_bytes.h"
#include "tests/small_support.h"

namespace selvage::mapper {
namespace {

using spec::kPixel_fx8;
using spec::kTexel_fx16;

[[nodiscard]] bool is_small_drawable(const SmallOutline& outline) {
  Polygon polygon;
  return examine(outline, &polygon) == SELVAGE_OK;
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

// All equal; or up to four times as great as the least, or hardly more: whole numbers of it, of
// which many quotients are whole, or any.
void set_any_depths(spec::Random& random, SmallOutline* outline) {
  const int32_t least = random.pick({1, 1, 2, 3, 1000, random.in(1, 1 << 22), (1 << 22) - 1});
  const int32_t kind = random.in(0, 4);
  for (selvage_vertex& vertex : *outline) {
    vertex.q = least;
    if (kind == 1) vertex.q *= random.in(1, 5);
    if (kind == 2) vertex.q = random.in(least, 4 * least + 2);
    if (kind == 3) vertex.q += random.in(0, least / 64 + 2);
  }
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
    set_any_depths(random, &outline);
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

// Each triangle by the mapping that a call for itself would choose.
TEST(SmallTriangles, AreMappedAsByACallEachWithinATolerance) {
  for (uint64_t seed = 1; seed <= 3000; ++seed) {
    spec::Random random(seed);
    const spec::Case c = any_small_case(random);
    const std::vector<SmallOutline> outlines = any_small_outlines(random, c);
    const spec::TextureMemory texture = texture_of(c);
    const int32_t tolerance = random.pick({1, kTexel_fx16 / 16, kTexel_fx16});
    for (const selvage_kernel kernel : usable_kernels()) {
      const DrawnBy by{kernel, 1, tolerance};
      ASSERT_TRUE(draw_together(c, texture.view(), outlines, by) ==
                  draw_each(c, texture.view(), outlines, by))
          << "kernel " << kernel << ", tolerance " << tolerance << ", seed " << seed;
    }
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
      static_cast<void>(draw_together(c, texture, outlines, {kernel}));
    }
  }
}

// A list, clipped, on some rows, which are returned one after another.
template <class Pixel>
[[nodiscard]] std::vector<Pixel> rows_drawn(selvage_format format, char* first_row, ptrdiff_t pitch,
                                            selvage_kernel kernel) {
  constexpr int32_t kWidth_px = 40, kRows = 10, kSide_texel = 32;
  std::vector<Pixel> texels(size_t{kSide_texel} * kSide_texel);
  std::iota(texels.begin(), texels.end(), Pixel{1});
  const selvage_texture texture{
      texels.data(), kSide_texel,         kSide_texel, kSide_texel * ptrdiff_t{sizeof(Pixel)},
      format,        SELVAGE_LAYOUT_ROWS, nullptr};
  const selvage_image target{first_row, kWidth_px, kRows, pitch, format};
  std::vector<SmallOutline> outlines;
  for (int32_t i = 0; i < 11; ++i) {
    const int32_t x_fx8 = i * 3 * kPixel_fx8 + 17, u_fx16 = i * kTexel_fx16;
    outlines.push_back({{x_fx8, 30 * i, u_fx16, kTexel_fx16, 1},
                        {x_fx8 + 9 * kPixel_fx8, 100 + 40 * i, u_fx16 + 7 * kTexel_fx16, 0, 1},
                        {x_fx8 + kPixel_fx8, 2500 - 40 * i, u_fx16, 20 * kTexel_fx16, 1}});
  }
  std::vector<selvage_polygon> polygons;
  for (const SmallOutline& outline : outlines) {
    polygons.push_back({outline.data(), outline.size(), &texture});
  }
  selvage_options options{};
  options.kernel = kernel;
  const size_t bytes = selvage_draw_many_bytes(polygons.size());
  std::vector<std::max_align_t> scratch(bytes / sizeof(std::max_align_t) + 1);
  const selvage_rect clip{2, 1, kWidth_px, kRows - 1};
  EXPECT_EQ(selvage_draw_many(&target, &clip, polygons.data(), polygons.size(), &options, 1,
                              scratch.data(), bytes, nullptr),
            SELVAGE_OK);
  std::vector<Pixel> pixels(size_t{kWidth_px} * kRows);
  for (int32_t row = 0; row < kRows; ++row) {
    std::memcpy(pixels.data() + row * kWidth_px, first_row + row * pitch,
                kWidth_px * sizeof(Pixel));
  }
  return pixels;
}

// 32 bits hold how many bytes one row is from the next, but not from the one nine rows away.
template <class Pixel>
void expect_far_rows_alike(selvage_format format) {
  constexpr ptrdiff_t kNear = 160, kFar = ptrdiff_t{1} << 28, kLastRow = 9 * kFar;
  std::vector<char> near(10 * kNear);
  const auto wanted = rows_drawn<Pixel>(format, near.data(), kNear, SELVAGE_KERNEL_SCALAR);
  ASSERT_GT(std::count_if(wanted.begin(), wanted.end(), [](Pixel p) { return p != 0; }), 150);
  for (const selvage_kernel kernel : usable_kernels()) {
    for (const bool up : {false, true}) {
      const FencedBytes memory(kLastRow + kNear, FencedBytes::Side::kFirst);
      EXPECT_EQ(up ? rows_drawn<Pixel>(format, memory.first() + kLastRow, -kFar, kernel)
                   : rows_drawn<Pixel>(format, memory.first(), kFar, kernel),
                wanted)
          << "kernel " << kernel;
    }
  }
}

TEST(SmallTriangles, RowsMayBeFarApart) {
  expect_far_rows_alike<uint8_t>(SELVAGE_INDEX8);
  expect_far_rows_alike<uint16_t>(SELVAGE_RGB565);
  expect_far_rows_alike<uint32_t>(SELVAGE_RGBA8888);
}

}  // namespace
}  // namespace selvage::mapper
