// The testbed's arithmetics: never out of bounds, right where it is easy, and wrong where and as
// their number format says.
#include "reports/stability/arithmetic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "reports/stability/arithmetic_floor.h"
#include "spec/generate.h"
#include "spec/laws.h"
#include "spec/picture.h"
#include "spec/verify.h"
#include "spec/vertex_units.h"

namespace selvage::stability {

void PrintTo(const Arithmetic& arithmetic, std::ostream* out) { *out << arithmetic.name; }

namespace {

using spec::Case;
using spec::kPixel_fx8;
using spec::kTexel_fx16;
using spec::Picture;

[[nodiscard]] spec::Subject subject_of(const Arithmetic& arithmetic) {
  return {std::string(arithmetic.name), arithmetic.draw};
}

class Arithmetics : public testing::TestWithParam<Arithmetic> {
 protected:
  [[nodiscard]] static Picture drawn(const Case& c) {
    return spec::draw(subject_of(GetParam()), c);
  }
};

TEST_P(Arithmetics, TouchNothingButThePixels) {
  for (uint64_t seed = 1; seed <= 3000; ++seed) {
    const Case c = spec::generate(seed);
    ASSERT_EQ(drawn(c).memory_fault, "") << "seed " << seed << '\n' << spec::print(c);
  }
}

// Clipping and every odd argument, by the laws that any mapper can keep.
TEST_P(Arithmetics, KeepTheLawsOfRobustness) {
  for (const char* name : {"MEM", "TOTAL"}) {
    const spec::Law* law = spec::find_law(name);
    ASSERT_NE(law, nullptr);
    const spec::LawVerdict verdict = spec::verify(*law, subject_of(GetParam()), 1, 200);
    EXPECT_FALSE(verdict.violation) << explain(*verdict.violation);
    EXPECT_GT(verdict.judged_px, 0u);
  }
}

// Everything at the ends of its range at once, where floats overflow and q vanishes in rounding.
TEST_P(Arithmetics, SurviveTheEndsOfEveryRange) {
  constexpr int32_t positions[] = {SELVAGE_X_MIN, SELVAGE_X_MIN + 1, -1, 0, 129, SELVAGE_X_END - 1};
  constexpr int32_t texels[] = {INT32_MIN, INT32_MAX, 0};
  constexpr int32_t weights[] = {1, SELVAGE_Q_MAX};
  for (uint32_t choice = 0; choice < 2000; ++choice) {
    uint32_t rest = choice * 2654435761u;
    const auto pick = [&](const auto& values) {
      rest = rest * 1664525u + 1013904223u;
      return values[(rest >> 16) % std::size(values)];
    };
    Case c;
    c.address = choice % 2 == 0 ? SELVAGE_ADDRESS_CLAMP : SELVAGE_ADDRESS_WRAP;
    c.texture_width_texel = 7;
    for (int corner = 0; corner < 3; ++corner) {
      selvage_vertex vertex{};
      vertex.x = pick(positions);
      vertex.y = pick(positions);
      vertex.u = pick(texels);
      vertex.v = pick(texels);
      vertex.q = pick(weights);
      c.vertices.push_back(vertex);
    }
    ASSERT_EQ(drawn(c).memory_fault, "") << spec::print(c);
  }
}

// A rectangle whose map is exact in every number format: sides and factors are powers of two.
[[nodiscard]] Case copy(int32_t width_px, int32_t height_px, int32_t u_texel, int32_t v_texel) {
  Case c;
  c.target_width_px = 24;
  c.target_height_px = 20;
  const int32_t left = 3 * kPixel_fx8 + 64, top = 2 * kPixel_fx8 + 32;
  const int32_t right = left + width_px * kPixel_fx8, bottom = top + height_px * kPixel_fx8;
  c.vertices = {{left, top, 0, 0, 1},
                {right, top, u_texel * kTexel_fx16, 0, 1},
                {right, bottom, u_texel * kTexel_fx16, v_texel * kTexel_fx16, 1},
                {left, bottom, 0, v_texel * kTexel_fx16, 1}};
  return c;
}

TEST_P(Arithmetics, AreRightOnCopies) {
  for (const int32_t scale : {1, 2, 4, 8, 32, -8}) {
    Case c = copy(16, 8, scale, scale == 1 ? 1 : 16);
    for (const selvage_format format : {SELVAGE_INDEX8, SELVAGE_RGB565, SELVAGE_RGBA8888}) {
      for (const selvage_address address : {SELVAGE_ADDRESS_CLAMP, SELVAGE_ADDRESS_WRAP}) {
        c.format = format;
        c.address = address;
        const Picture expected = spec::expected(c);
        EXPECT_EQ(drawn(c).pixels, expected.pixels) << spec::print(c);
      }
    }
  }
}

TEST_P(Arithmetics, AreRightOnClippedAndFlippedCopies) {
  Case c = copy(16, 8, 16, 16);
  c.has_clip = true;
  c.clip = {5, 4, 11, 7};
  c.padding_px = 3;
  for (const bool flip_target : {false, true}) {
    for (const bool flip_texture : {false, true}) {
      c.flip_target = flip_target;
      c.flip_texture = flip_texture;
      EXPECT_EQ(drawn(c).pixels, spec::expected(c).pixels) << spec::print(c);
    }
  }
}

TEST_P(Arithmetics, DrawEitherWinding) {
  Case c = copy(16, 8, 16, 16);
  const Picture clockwise = drawn(c);
  std::reverse(c.vertices.begin(), c.vertices.end());
  EXPECT_EQ(drawn(c).pixels, clockwise.pixels);
}

// A square on whole pixels, cut along its diagonal: sixteen centres lie on the cut, and each is
// drawn by one side.
TEST_P(Arithmetics, NeitherOverlapNorTearAlongASharedEdge) {
  Case c = copy(16, 16, 16, 16);
  for (selvage_vertex& vertex : c.vertices) {
    vertex.x -= 64;
    vertex.y -= 32;
  }
  const std::vector<selvage_vertex> square = c.vertices;
  c.vertices = {square[0], square[1], square[2]};
  const Picture one = drawn(c);
  c.vertices = {square[0], square[2], square[3]};
  const Picture other = drawn(c);
  c.vertices = square;
  const Picture whole = spec::expected(c);
  for (size_t i = 0; i < whole.pixels.size(); ++i) {
    EXPECT_EQ(int{one.pixels[i].has_value()} + int{other.pixels[i].has_value()},
              int{whole.pixels[i].has_value()});
  }
}

TEST_P(Arithmetics, RefuseWhatIsNoOutlineAndDrawNothing) {
  Case c = copy(16, 8, 16, 16);
  c.vertices.resize(2);
  EXPECT_EQ(drawn(c).status, SELVAGE_ERROR_VERTEX_COUNT);
  for (const auto& pixel : drawn(c).pixels) EXPECT_FALSE(pixel);
}

// A trapezium in perspective: q 1 on the left, 3 on the right. Of the exact picture's texels an
// arithmetic that divides shows nearly all, one that takes q for equal few.
TEST_P(Arithmetics, DivideOrDropQAsTheySay) {
  Case c = copy(16, 16, 256, 256);
  c.texture_width_texel = c.texture_height_texel = 256;
  c.vertices = {c.vertices[0], c.vertices[1], c.vertices[2]};
  c.vertices[1].q = c.vertices[2].q = 3;
  const Picture picture = drawn(c), expected = spec::expected(c);
  int covered = 0, equal = 0;
  for (size_t i = 0; i < expected.pixels.size(); ++i) {
    covered += expected.pixels[i].has_value();
    equal += expected.pixels[i].has_value() && picture.pixels[i] == expected.pixels[i];
  }
  ASSERT_GT(covered, 100);
  if (GetParam().affine_only) {
    EXPECT_LT(equal, covered / 2);
  } else {
    EXPECT_GT(equal, covered * 9 / 10);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Arithmetics,
                         testing::ValuesIn(arithmetics().begin(), arithmetics().end()),
                         [](const auto& tested) {
                           std::string name;
                           for (const char letter : tested.param.name)
                             if (letter != '-') name += letter;
                           return name;
                         });

[[nodiscard]] std::vector<std::string> row_of(const Arithmetic& arithmetic, const Case& c) {
  const Picture picture = spec::draw(subject_of(arithmetic), c);
  std::vector<std::string> texels;
  for (int32_t x = 0; x < picture.width_px; ++x) {
    const auto& pixel = picture.at(x, 0);
    texels.push_back(pixel ? spec::describe_texel(*pixel) : "nothing");
  }
  return texels;
}

// u is 1/3, 1, 5/3 at the centres. 16.16 steps by 43690 from 21845 and meets 1 one unit short.
TEST(Fixed1616, RoundsItsSlopesDown) {
  Case c;
  c.target_width_px = 3;
  c.target_height_px = 1;
  c.vertices = {{0, 0, 0, 0, 1},
                {3 * kPixel_fx8, 0, 2 * kTexel_fx16, 0, 1},
                {3 * kPixel_fx8, kPixel_fx8, 2 * kTexel_fx16, kTexel_fx16, 1},
                {0, kPixel_fx8, 0, kTexel_fx16, 1}};
  EXPECT_EQ(row_of(fixed1616(), c),
            (std::vector<std::string>{"texel (0, 0)", "texel (0, 0)", "texel (1, 0)"}));
  EXPECT_EQ(row_of(float64_dda(), c),
            (std::vector<std::string>{"texel (0, 0)", "texel (1, 0)", "texel (1, 0)"}));
}

// The same from right to left, u 5/3, 1, 1/3: down is toward minus infinity, so 1 is missed here
// too.
TEST(Fixed1616, RoundsNegativeSlopesDownToo) {
  Case c;
  c.target_width_px = 3;
  c.target_height_px = 1;
  c.vertices = {{0, 0, 2 * kTexel_fx16, 0, 1},
                {3 * kPixel_fx8, 0, 0, 0, 1},
                {3 * kPixel_fx8, kPixel_fx8, 0, kTexel_fx16, 1},
                {0, kPixel_fx8, 2 * kTexel_fx16, kTexel_fx16, 1}};
  EXPECT_EQ(row_of(fixed1616(), c),
            (std::vector<std::string>{"texel (1, 0)", "texel (0, 0)", "texel (0, 0)"}));
}

// At 20000 texels a float's unit is 1/512 texel: u = 20001 - 1/1024 is rounded up. A double's is
// not.
TEST(Float32, HasTwentyFourBits) {
  Case c;
  c.target_width_px = c.target_height_px = 1;
  c.texture_width_texel = 30000;
  c.texture_height_texel = 1;
  const int32_t u = 20001 * kTexel_fx16 - kTexel_fx16 / 1024;
  c.vertices = {{0, 0, u, 0, 1},
                {kPixel_fx8, 0, u, 0, 1},
                {kPixel_fx8, kPixel_fx8, u, 0, 1},
                {0, kPixel_fx8, u, 0, 1}};
  EXPECT_EQ(row_of(float32_dda(), c), std::vector<std::string>{"texel (20001, 0)"});
  EXPECT_EQ(row_of(float32_plane(), c), std::vector<std::string>{"texel (20001, 0)"});
  EXPECT_EQ(row_of(float64_dda(), c), std::vector<std::string>{"texel (20000, 0)"});
}

TEST(FloorIndex, IsTheFloorAsFarAsIntegersGo) {
  EXPECT_EQ(floor_index(2.75f), 2);
  EXPECT_EQ(floor_index(-0.25f), -1);
  EXPECT_EQ(floor_index(-3.0), -3);
  EXPECT_EQ(floor_index(16777215.0f), 16777215);
  constexpr int32_t most = 1 << 30;
  EXPECT_EQ(floor_index(1e30f), most);
  EXPECT_EQ(floor_index(-1e300), -most);
  EXPECT_EQ(floor_index(std::numeric_limits<float>::infinity()), most);
  EXPECT_EQ(floor_index(std::numeric_limits<double>::quiet_NaN()), -most);
}

TEST(ArithmeticList, HasEachOnce) {
  std::vector<std::string> names;
  for (const Arithmetic& arithmetic : arithmetics()) {
    names.emplace_back(arithmetic.name);
    EXPECT_FALSE(arithmetic.statement.empty());
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"fixed1616", "float32-dda", "float32-plane", "float64-dda"}));
}

}  // namespace
}  // namespace selvage::stability
