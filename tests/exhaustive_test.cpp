// Every triangle with its vertices on a small half-pixel grid, pixel for pixel against the model.
// Half of the grid's points are sample points, half of its lines run through some: ties everywhere.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "spec/laws.h"
#include "spec/picture.h"
#include "spec/profiles.h"

namespace selvage::spec {
namespace {

inline constexpr int32_t kColumns = 10, kRows = 9;  // 117 480 triangles

[[nodiscard]] selvage_vertex grid_vertex(int32_t index, int32_t salt) {
  const int32_t x = index % kColumns * 128, y = index / kColumns * 128;
  // Whole and half texels, with and without perspective, so that texels tie as often as edges do.
  const int32_t u = (index * 3 + salt) % 17 * 32768, v = (index * 5 + salt) % 13 * 32768;
  return {x, y, u, v, salt % 3 == 0 ? 1 + index % 4 : 1};
}

// One in three keeps its order, one starts elsewhere, one runs the other way.
[[nodiscard]] std::array<int32_t, 3> ordered(int32_t a, int32_t b, int32_t c, int32_t salt) {
  if (salt % 3 == 1) return {b, c, a};
  if (salt % 3 == 2) return {c, b, a};
  return {a, b, c};
}

TEST(Exhaustive, TrianglesOfTheHalfPixelGrid) {
  const Subject subject = built_in();
  Case c;
  c.target_width_px = c.target_height_px = 5;
  c.texture_width_texel = 8;
  c.texture_height_texel = 7;
  c.address = SELVAGE_ADDRESS_WRAP;
  int32_t triangles = 0;
  uint64_t covered_px = 0;
  const int32_t points = kColumns * kRows;
  for (int32_t i = 0; i < points; ++i) {
    for (int32_t j = i + 1; j < points; ++j) {
      for (int32_t k = j + 1; k < points; ++k, ++triangles) {
        c.vertices.clear();
        for (const int32_t index : ordered(i, j, k, triangles)) {
          c.vertices.push_back(grid_vertex(index, triangles));
        }
        const Picture model = expected(c), drawn = draw(subject, c);
        ASSERT_EQ(drawn.pixels, model.pixels) << print(c) << to_hex(c);
        ASSERT_EQ(drawn.memory_fault, "");
        for (const auto& pixel : drawn.pixels) covered_px += pixel.has_value() ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(triangles, 117480);
  EXPECT_GT(covered_px, 100000U);
}

// The same with filters: weights tie at every half texel, and boxes from half a texel to dozens.
TEST(Exhaustive, TrianglesOfTheHalfPixelGridWithFilters) {
  constexpr int32_t kSide = 8;
  const Subject subject = built_in();
  Case c;
  c.target_width_px = c.target_height_px = 4;
  c.texture_width_texel = 8;
  c.texture_height_texel = 7;
  int32_t triangles = 0;
  uint64_t covered_px = 0;
  for (int32_t i = 0; i < kSide * kSide; ++i) {
    for (int32_t j = i + 1; j < kSide * kSide; ++j) {
      for (int32_t k = j + 1; k < kSide * kSide; ++k, ++triangles) {
        c.vertices.clear();
        for (const int32_t index : ordered(i, j, k, triangles)) {
          selvage_vertex v = grid_vertex(index, triangles);
          v.x = index % kSide * 128;
          v.y = index / kSide * 128;
          c.vertices.push_back(v);
        }
        c.filter = SELVAGE_FILTER_FOUR + triangles / 3 % 3;
        c.address = triangles % 2 == 0 ? SELVAGE_ADDRESS_WRAP : SELVAGE_ADDRESS_CLAMP;
        const Picture model = expected(c), drawn = draw(subject, c);
        ASSERT_EQ(drawn.pixels, model.pixels) << print(c) << to_hex(c);
        for (const auto& pixel : drawn.pixels) covered_px += pixel.has_value() ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(triangles, 41664);
  EXPECT_GT(covered_px, 50000U);
}

// The same for the historic profiles, on whole pixels: every triangle, either way round.
TEST(Exhaustive, TrianglesOfWholePixelsInHistoricProfiles) {
  constexpr int32_t kSide = 7;
  Case c;
  c.target_width_px = c.target_height_px = kSide;
  c.texture_width_texel = 8;
  c.texture_height_texel = 7;
  c.address = SELVAGE_ADDRESS_WRAP;
  const auto vertex = [](int32_t index, int32_t salt) {
    return selvage_vertex{index % kSide * 256, index / kSide * 256, (index * 3 + salt) % 17 * 32768,
                          (index * 5 + salt) % 13 * 32768, 1};
  };
  for (const Profile& profile : profiles().subspan(1)) {
    c.profile = profile.id;
    const Subject subject = built_in(profile.id);
    int32_t triangles = 0;
    uint64_t covered_px = 0;
    for (int32_t i = 0; i < kSide * kSide; ++i) {
      for (int32_t j = i + 1; j < kSide * kSide; ++j) {
        for (int32_t k = j + 1; k < kSide * kSide; ++k, ++triangles) {
          c.vertices.clear();
          for (const int32_t index : ordered(i, j, k, triangles)) {
            c.vertices.push_back(vertex(index, triangles));
          }
          const Picture model = expected(c), drawn = draw(subject, c);
          ASSERT_EQ(drawn.pixels, model.pixels) << print(c) << to_hex(c);
          ASSERT_EQ(drawn.memory_fault, "");
          for (const auto& pixel : drawn.pixels) covered_px += pixel.has_value() ? 1 : 0;
        }
      }
    }
    EXPECT_EQ(triangles, 18424);
    EXPECT_GT(covered_px, 20000U) << profile.name;
  }
}

}  // namespace
}  // namespace selvage::spec
