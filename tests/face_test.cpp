// The C++ face, and the README's example.
#include "selvage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace selvage {
namespace {

inline constexpr int32_t kSide_px = 256, kSide_texel = 64;

struct Pictures {
  std::vector<uint32_t> pixels = std::vector<uint32_t>(kSide_px * kSide_px, 7);
  std::vector<uint32_t> texels = std::vector<uint32_t>(kSide_texel * kSide_texel, 9);

  [[nodiscard]] Image target() {
    return {pixels.data(), kSide_px, kSide_px, kSide_px * 4, SELVAGE_RGBA8888};
  }
  [[nodiscard]] Texture texture() const {
    return {texels.data(),    kSide_texel,         kSide_texel, kSide_texel * 4,
            SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
  }
  [[nodiscard]] auto drawn() const { return std::ranges::count(pixels, 9U); }
};

[[nodiscard]] std::array<Vertex, 3> corners() {
  std::array<Vertex, 3> v{};
  EXPECT_EQ(selvage_snap(10, 10, 0, 0, 1, 1, &v[0]), SELVAGE_OK);
  EXPECT_EQ(selvage_snap(200.5, 40, 64, 0, 1, 1, &v[1]), SELVAGE_OK);
  EXPECT_EQ(selvage_snap(60, 180, 64, 64, 1, 1, &v[2]), SELVAGE_OK);
  return v;
}

TEST(Face, DrawsWhatTheCInterfaceDraws) {
  Pictures by_face, by_c;
  const auto v = corners();
  const Texture texture = by_face.texture();
  ASSERT_EQ(draw(by_face.target(), v, texture), SELVAGE_OK);
  const Image target = by_c.target();
  ASSERT_EQ(selvage_draw(&target, nullptr, v.data(), v.size(), &texture, nullptr), SELVAGE_OK);
  EXPECT_EQ(by_face.pixels, by_c.pixels);
  EXPECT_GT(by_face.drawn(), 14000);  // half of (190.5 x 170 - 30 x 50)
  EXPECT_LT(by_face.drawn(), 16500);
}

TEST(Face, PassesClipAndOptionsOn) {
  Pictures pictures;
  ASSERT_EQ(draw(pictures.target(), corners(), pictures.texture(), {}, Rect{60, 60, 70, 70}),
            SELVAGE_OK);
  EXPECT_EQ(pictures.drawn(), 100);
  const Options unknown{SELVAGE_PROFILE_EXACT, SELVAGE_FILTER_NEAREST, 9, 0};
  EXPECT_EQ(draw(pictures.target(), corners(), pictures.texture(), unknown), SELVAGE_ERROR_ADDRESS);
}

}  // namespace
}  // namespace selvage
