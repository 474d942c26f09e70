// The area filter by every kernel, against the model, where a side of 1/256 texel more or less, or
// a point a step further, makes another pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "mapper/footprint.h"
#include "spec/gradient.h"
#include "spec/model.h"
#include "spec/picture.h"
#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/kernel_support.h"
#include "tests/modelled.h"

namespace selvage::mapper {
namespace {

using spec::Case;
using spec::kPixel_fx8;
using spec::kTexel_fx16;

// Texels of 0 and 255 side by side.
[[nodiscard]] uint32_t contrast(spec::Texel at) {
  const auto s = static_cast<uint32_t>(at.s), t = static_cast<uint32_t>(at.t);
  const uint32_t mixed = (s * 40503U + t * 7919U + 1) * 2654435761U;
  uint32_t texel = 0;
  for (int k = 0; k < 4; ++k) texel |= (mixed >> (13 + k) & 1) * (0xFFU << (8 * k));
  return texel;
}

// A column, or a row, each side of 1: a box about 1 that is whole and even has a mean of 254.5, or
// of 253.5 in the channels between; any other takes more of what lies beyond 1.
[[nodiscard]] uint32_t halves(bool beyond) { return beyond ? 0xFEFFFEFFU : 0xFFFEFFFEU; }

[[nodiscard]] Case area_case(int32_t width_px, int32_t height_px) {
  Case c;
  c.filter = SELVAGE_FILTER_AREA;
  c.address = SELVAGE_ADDRESS_WRAP;
  c.target_width_px = width_px;
  c.target_height_px = height_px;
  c.texture_width_texel = 37;
  c.texture_height_texel = 29;
  return c;
}

// The least boxes are bilinear, and no others.
TEST(AreaBoxes, OfAffineMapsHaveTheirSides) {
  for (const int32_t u_side : {255, 256, 257, 700}) {
    for (const int32_t v_side : {255, 256, 257, 700}) {
      Case c = area_case(21, 9);
      constexpr int32_t kEnd_px = 32;
      c.vertices = {{0, 0, 1234, 4321, 1},
                    {kEnd_px * kPixel_fx8, 0, 1234 + kEnd_px * u_side * 256, 4321, 1},
                    {0, kEnd_px * kPixel_fx8, 1234, 4321 + kEnd_px * v_side * 256, 1}};
      expect_drawn_as_modelled(c, contrast);
      ASSERT_FALSE(HasFatalFailure());
    }
  }
}

// Four texels in three pixels: no lane holds such a step, so that every third pixel lies a little
// before a point of the grid that it is on.
TEST(AreaBoxes, OfAffineMapsBeginAtPointsOfTheGrid) {
  for (const int32_t shift_fx8 : {0, 1, -300 * 256}) {
    Case c = area_case(150, 3);
    constexpr int32_t kEnd_px = 3 * 64;
    const int32_t shift = shift_fx8 * (kTexel_fx16 / 256);
    c.vertices = {{0, 0, shift, shift, 1},
                  {kEnd_px * kPixel_fx8, 0, kEnd_px / 3 * 4 * kTexel_fx16 + shift, shift, 1},
                  {0, kEnd_px * kPixel_fx8, shift, kEnd_px / 3 * 5 * kTexel_fx16 + shift, 1}};
    expect_drawn_as_modelled(c, contrast);
    ASSERT_FALSE(HasFatalFailure());
  }
}

// Triangles as large as they may be, whose lanes are off by so much that some points lie beyond the
// next step of the grid: by integers of more than 64 bits.
TEST(AreaBoxes, OfSteepDepthsBeginAtTheirPoints) {
  spec::Random random(3);
  int drawn = 0;
  for (int i = 0; i < 4000 && drawn < 30; ++i) {
    Case c = area_case(40, 12);
    const auto texel = [&] { return random.in(INT32_MIN, int64_t{INT32_MAX} + 1); };
    const int32_t far_q = random.in(1 << 6, 1 << 10), near_q = random.in(1 << 23, 1 << 24);
    c.vertices = {{SELVAGE_X_MIN, random.in(SELVAGE_X_MIN, 0), texel(), texel(), far_q},
                  {SELVAGE_X_END - 1, random.in(SELVAGE_X_MIN, -9000), texel(), texel(), near_q},
                  {random.in(0, SELVAGE_X_END), SELVAGE_X_END - 1, texel(), texel(), near_q}};
    const auto gradient = spec::gradient(c.vertices, 20, 6);
    if (!gradient) continue;
    const spec::BoxSides sides = spec::box_sides(*gradient);
    if (std::max(sides.u_fx8, sides.v_fx8) > 1500) continue;
    if (std::max(sides.u_fx8, sides.v_fx8) == kLeastSide_fx8) continue;
    ++drawn;
    expect_drawn_as_modelled(c, contrast);
    ASSERT_FALSE(HasFatalFailure()) << i;
  }
  EXPECT_EQ(drawn, 30);
}

// Rows of more than one piece in which boxes are the least, and larger.
TEST(AreaBoxes, OfProjectiveMapsHaveTheirSides) {
  spec::Random random(4);
  for (int i = 0; i < 12; ++i) {
    Case c = area_case(150, 2);
    const auto texel = [&] { return random.in(-150 * kTexel_fx16, 150 * kTexel_fx16); };
    const auto q = [&] { return random.in(1 << 10, 1 << 12); };
    constexpr int32_t kEnd = 170 * kPixel_fx8;
    const int32_t top = random.in(-9 * kPixel_fx8, 1);
    const int32_t bottom = random.in(3 * kPixel_fx8, 99 * kPixel_fx8);
    c.vertices = {{-300, top, texel(), texel(), q()},
                  {kEnd, top, texel(), texel(), q()},
                  {kEnd / 2, bottom, texel(), texel(), q()}};
    expect_drawn_as_modelled(c, contrast);
    ASSERT_FALSE(HasFatalFailure()) << i;
  }
}

// ---- Sides that doubles cannot tell ------------------------------------------------------------

// 1 / a modulo m, both odd or coprime, by Euclid.
[[nodiscard]] int64_t inverse(int64_t a, int64_t m) {
  int64_t x = 1, next_x = 0, rest = a % m, next = m;
  while (next != 0) {
    const int64_t quotient = rest / next;
    rest = std::exchange(next, rest - quotient * next);
    x = std::exchange(next_x, x - quotient * next_x);
  }
  return rest == 1 ? (x % m + m) % m : 0;
}

// Depth and one coordinate change down the target alone, the other not at all: in row 0 all boxes
// have this side, to which 2^-40 texel and less is added, or from which it is taken. With depths q0
// and q1 in a distance of h, a side is q1 (u1 - u0) / (h q0).
struct FlatSide {
  int32_t side_fx8, beyond;  // -1 or 1
  bool along_u;
};
[[nodiscard]] std::optional<Case> flat_case(const FlatSide& of, int32_t width_px, uint64_t seed) {
  constexpr int32_t kDown = 1 << 22;
  spec::Random random(seed);
  const int64_t q1 = random.in(1 << 22, 1 << 23) | 1;
  const int64_t product = int64_t{of.side_fx8} * kDown % q1;
  const int64_t inverse_q1 = inverse(product, q1);
  const int64_t q0 = of.beyond < 0 ? inverse_q1 : (q1 - inverse_q1) % q1;
  if (inverse_q1 == 0 || q0 < q1 / 4) return {};
  const int64_t change = (int64_t{of.side_fx8} * kDown * q0 + of.beyond) / q1;
  if (change >= int64_t{1} << 31) return {};
  EXPECT_EQ(change * q1, int64_t{of.side_fx8} * kDown * q0 + of.beyond);
  Case c = area_case(width_px, 2);
  c.address = SELVAGE_ADDRESS_CLAMP;
  c.texture_width_texel = c.texture_height_texel = 2;
  const auto vertex = [&](int32_t x, int32_t y, int64_t along, int64_t q) {
    const auto texel = static_cast<int32_t>(along);
    return of.along_u ? selvage_vertex{x, y, texel, kTexel_fx16, static_cast<int32_t>(q)}
                      : selvage_vertex{x, y, kTexel_fx16, texel, static_cast<int32_t>(q)};
  };
  const int32_t end = (width_px + 9) * kPixel_fx8;
  c.vertices = {vertex(-9, 128, kTexel_fx16, q0), vertex(end, 128, kTexel_fx16, q0),
                vertex(-9, 128 + kDown, kTexel_fx16 - change, q1)};
  return c;
}

TEST(AreaBoxes, HaveSidesThatDoublesCannotTell) {
  int drawn = 0;
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    for (const int32_t side_fx8 : {256, 300, 512 + 4}) {
      for (const int32_t beyond : {-1, 1}) {
        for (const bool along_u : {false, true}) {
          const auto c = flat_case({side_fx8, beyond, along_u}, 21, seed);
          if (!c) continue;
          ++drawn;
          const spec::BoxSides sides = spec::box_sides(*spec::gradient(c->vertices, 3, 0));
          ASSERT_EQ(along_u ? sides.u_fx8 : sides.v_fx8, side_fx8 + (beyond > 0 ? 1 : 0));
          ASSERT_EQ(along_u ? sides.v_fx8 : sides.u_fx8, kLeastSide_fx8);
          expect_drawn_as_modelled(
              *c, [&](spec::Texel at) { return halves(along_u ? at.s > 0 : at.t > 0); });
          ASSERT_FALSE(HasFatalFailure());
        }
      }
    }
  }
  EXPECT_GT(drawn, 30);
}

// Where they are the greatest, half of a box is either side of 1.
TEST(AreaBoxes, AreNoLargerThanTheGreatest) {
  for (const bool along_u : {false, true}) {
    Case c = area_case(21, 2);
    c.address = SELVAGE_ADDRESS_CLAMP;
    c.texture_width_texel = c.texture_height_texel = 2;
    constexpr int32_t kFar = INT32_MIN / 2;
    const int32_t u = along_u ? kFar : kTexel_fx16, v = along_u ? kTexel_fx16 : kFar;
    c.vertices = {{0, 128, kTexel_fx16, kTexel_fx16, 1},
                  {30 * kPixel_fx8, 128, kTexel_fx16, kTexel_fx16, 1},
                  {0, 128 + 2 * kPixel_fx8, u, v, 1 << 10}};
    const spec::BoxSides sides = spec::box_sides(*spec::gradient(c.vertices, 3, 0));
    ASSERT_EQ(along_u ? sides.u_fx8 : sides.v_fx8, kMostSide_fx8);
    expect_drawn_as_modelled(c,
                             [&](spec::Texel at) { return halves(along_u ? at.s > 0 : at.t > 0); });
    ASSERT_FALSE(HasFatalFailure());
  }
}

}  // namespace
}  // namespace selvage::mapper
