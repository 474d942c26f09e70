// Large images and long outlines, pixel for pixel against the model: what small cases cannot show.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "spec/picture.h"

namespace selvage::spec {
namespace {

void expect_exact(const Case& c) {
  const Picture model = expected(c), drawn = draw(built_in(), c);
  ASSERT_EQ(drawn.status, SELVAGE_OK) << selvage_status_text(drawn.status);
  ASSERT_EQ(drawn.memory_fault, "");
  uint64_t covered = 0;
  for (size_t i = 0; i < model.pixels.size(); ++i) {
    ASSERT_EQ(drawn.pixels[i], model.pixels[i]) << "pixel " << i << " of " << print(c);
    covered += model.pixels[i] ? 1 : 0;
  }
  EXPECT_GT(covered, model.pixels.size() / 4);
}

[[nodiscard]] Case sized(int32_t width_px, int32_t height_px, int32_t width_texel,
                         int32_t height_texel) {
  Case c;
  c.target_width_px = width_px;
  c.target_height_px = height_px;
  c.texture_width_texel = width_texel;
  c.texture_height_texel = height_texel;
  return c;
}

// Spans of 32 768 pixels over the whole of a long texture, in both directions.
TEST(Large, SpansAsWideAsTheRange) {
  const int32_t last = SELVAGE_X_END - 1, texels = 32767 * 65536;
  for (const int32_t q : {1, 3, int32_t{SELVAGE_Q_MAX}}) {
    Case c = sized(65536, 1, 65536, 1);
    c.vertices = {{-500, 0, 0, 0, 1},
                  {last, 0, texels, 9, q},
                  {last, 256, texels, 9, q},
                  {-500, 256, 17, 0, 1}};
    expect_exact(c);
    std::swap(c.vertices[0].u, c.vertices[1].u);
    c.address = SELVAGE_ADDRESS_WRAP;
    c.texture_width_texel = 32001;
    expect_exact(c);
  }
}

TEST(Large, AsManyRowsAsTheRangeHas) {
  const int32_t last = SELVAGE_X_END - 1, texels = 32767 * 65536;
  for (const int32_t q : {1, 1000}) {
    Case c = sized(1, 65536, 1, 65536);
    c.vertices = {{0, -500, 3, 0, 1},
                  {300, -500, 5, 0, q},
                  {260, last, 5, texels, 1},
                  {-20, last, 3, texels, q}};
    expect_exact(c);
  }
}

TEST(Large, AScreenThatIsTurned) {
  Case c = sized(320, 200, 256, 256);
  c.vertices = {{20000, -9000, 0, 0, 7},
                {90000, 20000, 256 * 65536, 0, 5},
                {60000, 60000, 256 * 65536, 256 * 65536, 3},
                {-9000, 30000, 0, 256 * 65536, 5}};
  expect_exact(c);
}

TEST(Large, OutlinesOfAThousandVertices) {
  Case c = sized(96, 96, 64, 64);
  for (int i = 0; i < 1000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 1000;
    selvage_vertex v{};
    ASSERT_EQ(selvage_snap(48 + 47 * std::cos(angle), 48 + 47 * std::sin(angle),
                           32 + 32 * std::cos(3 * angle), 32 + 32 * std::sin(angle), 1, 1, &v),
              SELVAGE_OK);
    c.vertices.push_back(v);
  }
  expect_exact(c);
}

}  // namespace
}  // namespace selvage::spec
