// Drawing within a tolerance: what is chosen, and that neither clip nor place changes it, nor any
// kernel that steps the same rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "selvage.h"
#include "spec/law_tools.h"
#include "spec/picture.h"
#include "spec/random.h"
#include "spec/subject.h"
#include "spec/tolerance.h"
#include "tests/kernel_support.h"

namespace selvage {
namespace {

using spec::Case;
using spec::Picture;

[[nodiscard]] Picture drawn(const Case& c, int32_t tolerance,
                            selvage_kernel kernel = SELVAGE_KERNEL_SCALAR) {
  spec::Subject subject{
      "within a tolerance",
      [=](const selvage_image* target, const selvage_rect* clip, const selvage_vertex* vertices,
          size_t count, const selvage_texture* texture, const selvage_options* options) {
        selvage_options changed = *options;
        changed.tolerance = tolerance;
        changed.kernel = kernel;
        return selvage_draw(target, clip, vertices, count, texture, &changed);
      }};
  subject.prepare = spec::built_in().prepare;
  return spec::draw(subject, c);
}

// A quad whose q goes from `near` to `far` as u does.
[[nodiscard]] Case quad(int32_t width_px, int32_t near, int32_t far) {
  Case c;
  c.target_width_px = width_px;
  c.target_height_px = 3;
  c.texture_width_texel = c.texture_height_texel = 256;
  const int32_t right = width_px * SELVAGE_SUBPIXELS, bottom = 3 * SELVAGE_SUBPIXELS;
  constexpr int32_t kEnd = 256 * SELVAGE_SUBTEXELS;
  c.vertices = {{0, 0, 0, 0, near},
                {right, 0, kEnd, 0, far},
                {right, bottom, kEnd, kEnd, far},
                {0, bottom, 0, kEnd, near}};
  return c;
}

[[nodiscard]] selvage_choice chosen(const Case& c, int32_t tolerance,
                                    selvage_kernel kernel = SELVAGE_KERNEL_SCALAR) {
  std::vector<uint32_t> pixels(static_cast<size_t>(c.target_width_px * c.target_height_px));
  std::vector<uint32_t> texels(1);
  const selvage_image target{pixels.data(), c.target_width_px, c.target_height_px,
                             ptrdiff_t{c.target_width_px} * 4, SELVAGE_RGBA8888};
  const selvage_texture texture{texels.data(),       1,      1, 4, SELVAGE_RGBA8888,
                                SELVAGE_LAYOUT_ROWS, nullptr};
  const selvage_options options{c.profile, c.filter, c.address, tolerance, kernel};
  selvage_choice choice{-1, -1, -1};
  EXPECT_EQ(selvage_choose(&target, c.has_clip ? &c.clip : nullptr, c.vertices.data(),
                           c.vertices.size(), &texture, &options, &choice),
            SELVAGE_OK);
  EXPECT_TRUE(std::ranges::all_of(pixels, [](uint32_t pixel) { return pixel == 0; }));
  return choice;
}

TEST(Choice, IsTheCheapestThatTheToleranceAllows) {
  const Case c = quad(640, 1 << 20, (1 << 20) + (1 << 18));  // q in the ratio 1.25
  EXPECT_EQ(chosen(c, 0).method, SELVAGE_METHOD_EXACT_PERSPECTIVE);
  EXPECT_EQ(chosen(c, 3).method, SELVAGE_METHOD_EXACT_PERSPECTIVE);
  const selvage_choice quarter = chosen(c, SELVAGE_SUBTEXELS / 4);
  EXPECT_EQ(quarter.method, SELVAGE_METHOD_SUBDIVIDED);
  EXPECT_EQ(quarter.segment_px % 16, 0);
  const selvage_choice one = chosen(c, SELVAGE_SUBTEXELS);
  EXPECT_GT(one.segment_px, quarter.segment_px);
  EXPECT_GT(one.bound, quarter.bound);
  const selvage_choice any = chosen(c, 1 << 30);
  EXPECT_EQ(any.method, SELVAGE_METHOD_AFFINE_FOR_PERSPECTIVE);
  EXPECT_EQ(any.segment_px, 0);
  // Its own bound is tolerance enough, and not a unit less.
  EXPECT_EQ(chosen(c, any.bound).method, SELVAGE_METHOD_AFFINE_FOR_PERSPECTIVE);
  EXPECT_EQ(chosen(c, any.bound - 1).method, SELVAGE_METHOD_SUBDIVIDED);
}

// 16 px longer, and the bound of the specification would be beyond the tolerance.
TEST(Choice, HasTheLongestSegmentsThatItsBoundAllows) {
  const Case c = quad(2000, 1 << 20, (1 << 20) + (1 << 19));
  const auto line = spec::scan_line(c.vertices, 1);
  for (const int32_t tolerance : {4096, 16384, 40000, 65536, 100000}) {
    const selvage_choice choice = chosen(c, tolerance);
    ASSERT_EQ(choice.method, SELVAGE_METHOD_SUBDIVIDED) << tolerance;
    const auto chord_fx16 = [&](int32_t segment_px) {
      return spec::chord_bound(*line, segment_px).get_d() * 65536.0;
    };
    EXPECT_LE(chord_fx16(choice.segment_px), choice.bound);
    EXPECT_LE(choice.bound, tolerance);
    EXPECT_GT(chord_fx16(choice.segment_px + 16) + spec::rounding_bound_fx16(*line).get_d(),
              tolerance);
  }
}

void expect_exact(const selvage_choice& choice, selvage_method method) {
  EXPECT_EQ(choice.method, method);
  EXPECT_EQ(choice.segment_px, 0);
  EXPECT_EQ(choice.bound, 0);
}

TEST(Choice, NamesWhatIsExactWhateverTheTolerance) {
  Case c = quad(640, 7, 7);
  expect_exact(chosen(c, 65536), SELVAGE_METHOD_EXACT_AFFINE);
  c = quad(159, 100, 101);  // narrow rows
  expect_exact(chosen(c, 65536), SELVAGE_METHOD_EXACT_PERSPECTIVE);
  EXPECT_NE(chosen(quad(160, 100, 101), 65536).method, SELVAGE_METHOD_EXACT_PERSPECTIVE);
  c = quad(640, 100, 101);
  c.filter = SELVAGE_FILTER_BILINEAR;
  expect_exact(chosen(c, 65536), SELVAGE_METHOD_FILTER);
  c = quad(256, 7, 7);
  for (selvage_vertex& v : c.vertices) v.v = v.y * 256, v.u = v.x * 256;
  expect_exact(chosen(c, 65536), SELVAGE_METHOD_COPY);
  c.profile = SELVAGE_PROFILE_ABRASH56;
  expect_exact(chosen(c, 65536), SELVAGE_METHOD_HISTORIC);
  c = quad(640, 100, 101);
  c.has_clip = true;  // an empty one
  expect_exact(chosen(c, 65536), SELVAGE_METHOD_NONE);
  // The lowest coordinates there are: lanes could leave 32 bits.
  c = quad(640, 100, 101);
  c.vertices[0].u = INT32_MIN;
  expect_exact(chosen(c, 1 << 30), SELVAGE_METHOD_EXACT_PERSPECTIVE);
}

// What lanes lose by roundings alone is more.
TEST(Choice, IsExactWithinTheLeastTolerances) {
  const Case c = quad(640, 1 << 20, (1 << 20) + (1 << 18));
  for (const int32_t tolerance : {0, 1, 2, 3, 4}) {
    expect_exact(chosen(c, tolerance), SELVAGE_METHOD_EXACT_PERSPECTIVE);
  }
}

TEST(Choice, ChecksItsArgumentsAsDrawDoes) {
  selvage_choice choice{-1, -1, -1};
  EXPECT_EQ(selvage_choose(nullptr, nullptr, nullptr, 0, nullptr, nullptr, &choice),
            SELVAGE_ERROR_TARGET_NULL);
  EXPECT_EQ(choice.method, -1);
  const Case c = quad(4, 1, 2);
  std::vector<uint32_t> pixels(16), texels(1);
  const selvage_image target{pixels.data(), 4, 4, 16, SELVAGE_RGBA8888};
  const selvage_texture texture{texels.data(),       1,      1, 4, SELVAGE_RGBA8888,
                                SELVAGE_LAYOUT_ROWS, nullptr};
  EXPECT_EQ(selvage_choose(&target, nullptr, c.vertices.data(), 4, &texture, nullptr, nullptr),
            SELVAGE_ERROR_CHOICE_NULL);
  EXPECT_EQ(selvage_choose(&target, nullptr, c.vertices.data(), 2, &texture, nullptr, &choice),
            SELVAGE_ERROR_VERTEX_COUNT);
}

// Random polygons in perspective, wide enough for segments: quads that are no plane's, triangles,
// and triangles with a vertex more on an edge.
class Tolerant : public testing::TestWithParam<uint64_t> {
 protected:
  [[nodiscard]] Case scene() {
    spec::Random random(GetParam());
    const auto pick = [&](int32_t least, int32_t end) { return random.in(least, end); };
    Case c = quad(pick(200, 700), 1, 1);
    const int32_t base = pick(1 << 16, 1 << 20);
    for (selvage_vertex& v : c.vertices) {
      v.x += pick(-20000, 20000);
      v.y += pick(-300, 300);
      v.q = base + pick(0, base / 2);
    }
    if (GetParam() % 3 != 0) c.vertices.erase(c.vertices.begin() + pick(0, 4));
    if (GetParam() % 3 == 2) cut_edge(&c.vertices);
    c.format = pick(0, 3);
    c.address = pick(0, 2);
    c.texture_width_texel = pick(1, 257);
    tolerance_ = pick(1 << 10, 1 << 18);
    return c;
  }
  // At a third of the first edge, both of whose ends get one q.
  static void cut_edge(std::vector<selvage_vertex>* vertices) {
    selvage_vertex &a = (*vertices)[0], &b = (*vertices)[1];
    const auto whole = [](int32_t x) { return x / 3 * 3; };
    for (selvage_vertex* end : {&a, &b}) {
      *end = {whole(end->x), whole(end->y), whole(end->u), whole(end->v), a.q};
    }
    const auto third = [](int32_t from, int32_t to) { return from + (to - from) / 3; };
    const selvage_vertex cut{third(a.x, b.x), third(a.y, b.y), third(a.u, b.u), third(a.v, b.v),
                             a.q};
    vertices->insert(vertices->begin() + 1, cut);
  }
  int32_t tolerance_ = 0;
};

TEST_P(Tolerant, AllKernelsDrawTheSame) {
  const Case c = scene();
  const Picture scalar = drawn(c, tolerance_, SELVAGE_KERNEL_SCALAR);
  ASSERT_EQ(scalar.memory_fault, "");
  for (const selvage_kernel kernel : mapper::stepping_kernels()) {
    EXPECT_EQ(drawn(c, tolerance_, kernel).pixels, scalar.pixels) << "kernel " << kernel;
    EXPECT_EQ(chosen(c, tolerance_, kernel).bound, chosen(c, tolerance_).bound);
  }
}

TEST(Stepped, AllKernelsDrawTheSameFromWhateverTexture) {
  for (const selvage_format format : {SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888}) {
    for (const selvage_address address : {SELVAGE_ADDRESS_CLAMP, SELVAGE_ADDRESS_WRAP}) {
      for (const auto& [width, height] : {std::pair{128, 128}, {100, 100}, {128, 100}}) {
        for (const spec::Layout layout : {spec::Layout::kGiven, spec::Layout::kTiled}) {
          Case c = quad(400, 1 << 20, (1 << 20) + (1 << 17));
          c.format = format;
          c.address = address;
          c.layout = layout;
          c.texture_width_texel = width;
          c.texture_height_texel = height;
          ASSERT_GT(chosen(c, SELVAGE_SUBTEXELS).bound, 0);
          const Picture scalar = drawn(c, SELVAGE_SUBTEXELS, SELVAGE_KERNEL_SCALAR);
          ASSERT_EQ(scalar.status, SELVAGE_OK);
          for (const selvage_kernel kernel : mapper::stepping_kernels()) {
            EXPECT_EQ(drawn(c, SELVAGE_SUBTEXELS, kernel).pixels, scalar.pixels)
                << "kernel " << kernel << ", format " << format;
          }
        }
      }
    }
  }
}

// A segment reaches from pixel to pixel: that of a row's last pixel alone has no length.
TEST(Stepped, AllKernelsDrawTheSameLastPixel) {
  int rows = 0;
  for (int32_t width_px = 100; width_px < 1200; ++width_px) {
    const Case c = quad(width_px, 1 << 20, (1 << 20) + (1 << 18));
    const selvage_choice choice = chosen(c, SELVAGE_SUBTEXELS);
    if (choice.segment_px == 0 || (width_px - 1) % choice.segment_px != 0) continue;
    ++rows;
    const Picture scalar = drawn(c, SELVAGE_SUBTEXELS, SELVAGE_KERNEL_SCALAR);
    for (const selvage_kernel kernel : mapper::stepping_kernels()) {
      EXPECT_EQ(drawn(c, SELVAGE_SUBTEXELS, kernel).pixels, scalar.pixels) << width_px << " px";
    }
  }
  EXPECT_GT(rows, 0);
}

TEST(Stepped, AllKernelsDrawTheSameOfManySegments) {
  Case c = quad(6000, 1 << 20, (1 << 20) + (1 << 18));
  constexpr int32_t kTolerance = 300;
  const selvage_choice choice = chosen(c, kTolerance);
  ASSERT_EQ(choice.method, SELVAGE_METHOD_SUBDIVIDED);
  ASSERT_GT(c.target_width_px / choice.segment_px, 70) << choice.segment_px;
  const Picture scalar = drawn(c, kTolerance, SELVAGE_KERNEL_SCALAR);
  for (const selvage_kernel kernel : mapper::stepping_kernels()) {
    EXPECT_EQ(drawn(c, kTolerance, kernel).pixels, scalar.pixels) << "kernel " << kernel;
  }
}

TEST_P(Tolerant, ClippedIsCropped) {
  Case c = scene();
  const Picture whole = drawn(c, tolerance_);
  c.has_clip = true;
  for (const int32_t left : {1, 15, 16, 17, 150}) {
    c.clip = {left, 1, left + 37, 3};
    const Picture part = drawn(c, tolerance_);
    for (int32_t y = 0; y < c.target_height_px; ++y) {
      for (int32_t x = 0; x < c.target_width_px; ++x) {
        const bool inside = c.clip.left <= x && x < c.clip.right && y >= 1;
        ASSERT_EQ(part.at(x, y), inside ? whole.at(x, y) : std::nullopt) << x << ", " << y;
      }
    }
  }
}

TEST_P(Tolerant, NeitherFirstVertexNorWindingMatters) {
  Case c = scene();
  const Picture before = drawn(c, tolerance_);
  for (size_t turn = 0; turn < c.vertices.size(); ++turn) {
    std::ranges::rotate(c.vertices, c.vertices.begin() + 1);
    EXPECT_EQ(drawn(c, tolerance_).pixels, before.pixels);
    std::ranges::reverse(c.vertices);
    EXPECT_EQ(drawn(c, tolerance_).pixels, before.pixels);
  }
}

INSTANTIATE_TEST_SUITE_P(, Tolerant, testing::Range(uint64_t{0}, uint64_t{60}));

// The scenes above would show nothing if all of them were drawn exactly.
TEST(TolerantScenes, AreDrawnBySegments) {
  const Case c = quad(640, 1 << 20, (1 << 20) + (1 << 18));
  EXPECT_NE(drawn(c, SELVAGE_SUBTEXELS).pixels, drawn(c, 0).pixels);
}

}  // namespace
}  // namespace selvage
