// The C++ face, and the README's example.
#include "selvage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>
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

[[nodiscard]] std::array<Vertex, 3> snapped_triangle() {
  std::array<Vertex, 3> v{};
  EXPECT_EQ(selvage_snap(10, 10, 0, 0, 1, 1, &v[0]), SELVAGE_OK);
  EXPECT_EQ(selvage_snap(200.5, 40, 64, 0, 1, 1, &v[1]), SELVAGE_OK);
  EXPECT_EQ(selvage_snap(60, 180, 64, 64, 1, 1, &v[2]), SELVAGE_OK);
  return v;
}

TEST(Face, DrawsWhatTheCInterfaceDraws) {
  Pictures by_face, by_c;
  const auto v = snapped_triangle();
  const Texture texture = by_face.texture();
  ASSERT_EQ(draw(by_face.target(), v, texture), SELVAGE_OK);
  const Image target = by_c.target();
  ASSERT_EQ(selvage_draw(&target, nullptr, v.data(), v.size(), &texture, nullptr), SELVAGE_OK);
  EXPECT_EQ(by_face.pixels, by_c.pixels);
  EXPECT_GT(by_face.drawn(), 14000);  // half of (190.5 x 170 - 30 x 50)
  EXPECT_LT(by_face.drawn(), 16500);
}

TEST(Face, DrawsTheSameFromAPreparedTexture) {
  Pictures given, tiled;
  const Texture texture = given.texture();
  const size_t bytes = prepare_bytes(texture, SELVAGE_LAYOUT_TILES, true);
  alignas(SELVAGE_PREPARED_ALIGNMENT) static std::array<std::byte, 1 << 18> memory;
  ASSERT_LE(bytes, memory.size());
  Texture prepared{};
  ASSERT_EQ(prepare(texture, SELVAGE_LAYOUT_TILES, true, std::span(memory).first(bytes), prepared),
            SELVAGE_OK);
  ASSERT_EQ(draw(given.target(), snapped_triangle(), texture), SELVAGE_OK);
  ASSERT_EQ(draw(tiled.target(), snapped_triangle(), prepared), SELVAGE_OK);
  EXPECT_EQ(given.pixels, tiled.pixels);
  EXPECT_EQ(
      prepare(texture, SELVAGE_LAYOUT_TILES, true, std::span(memory).first(bytes - 1), prepared),
      SELVAGE_ERROR_PREPARE_SIZE);
}

TEST(Face, PreparesWithoutSumsToo) {
  Pictures given, tiled;
  const Texture texture = given.texture();
  const size_t bytes = prepare_bytes(texture, SELVAGE_LAYOUT_TILES, false);
  EXPECT_LT(bytes, prepare_bytes(texture, SELVAGE_LAYOUT_TILES, true));
  alignas(SELVAGE_PREPARED_ALIGNMENT) static std::array<std::byte, 1 << 18> memory;
  ASSERT_LE(bytes, memory.size());
  Texture prepared{};
  ASSERT_EQ(prepare(texture, SELVAGE_LAYOUT_TILES, false, std::span(memory).first(bytes), prepared),
            SELVAGE_OK);
  EXPECT_EQ(prepared.prepared, nullptr);
  ASSERT_EQ(draw(given.target(), snapped_triangle(), texture), SELVAGE_OK);
  ASSERT_EQ(draw(tiled.target(), snapped_triangle(), prepared), SELVAGE_OK);
  EXPECT_EQ(given.pixels, tiled.pixels);
}

TEST(Face, PassesClipAndOptionsOn) {
  Pictures pictures;
  ASSERT_EQ(
      draw(pictures.target(), snapped_triangle(), pictures.texture(), {}, Rect{60, 60, 70, 70}),
      SELVAGE_OK);
  EXPECT_EQ(pictures.drawn(), 100);
  const Options unknown{SELVAGE_PROFILE_EXACT, SELVAGE_FILTER_NEAREST, 9, 0, 0};
  EXPECT_EQ(draw(pictures.target(), snapped_triangle(), pictures.texture(), unknown),
            SELVAGE_ERROR_ADDRESS);
}

TEST(Face, SnapsAsTheCInterfaceDoes) {
  Vertex by_face{}, by_c{};
  ASSERT_EQ(snap({200.5, 40, 64, 0.25, 3}, by_face, 1.5), SELVAGE_OK);
  ASSERT_EQ(selvage_snap(200.5, 40, 64, 0.25, 3, 1.5, &by_c), SELVAGE_OK);
  EXPECT_EQ(std::tie(by_face.x, by_face.y, by_face.u, by_face.v, by_face.q),
            std::tie(by_c.x, by_c.y, by_c.u, by_c.v, by_c.q));
  ASSERT_EQ(snap({1, 2, 3, 4}, by_face), SELVAGE_OK);
  EXPECT_EQ(by_face.q, SELVAGE_Q_MAX);
  const selvage_status status = snap({1e9, 2, 3, 4}, by_face);
  EXPECT_NE(status, SELVAGE_OK);
  EXPECT_EQ(text_of(status), selvage_status_text(status));
}

// Anticlockwise on the screen, a picture as it is.
TEST(Face, FitsAPictureAsItIs) {
  Pictures pictures;
  for (size_t i = 0; i < pictures.texels.size(); ++i) pictures.texels[i] = static_cast<uint32_t>(i);
  std::array<Vertex, 4> corners{}, fitted{};
  constexpr int32_t kEnd_px = kSide_texel;
  const std::pair<int32_t, int32_t> places_px[] = {
      {0, 0}, {0, kEnd_px}, {kEnd_px, kEnd_px}, {kEnd_px, 0}};
  for (size_t i = 0; i < corners.size(); ++i) {
    corners[i] = {places_px[i].first * SELVAGE_SUBPIXELS, places_px[i].second * SELVAGE_SUBPIXELS,
                  0, 0, 1};
  }
  const Texture texture = pictures.texture();
  ASSERT_EQ(fit(corners, texture, fitted), SELVAGE_OK);
  Choice choice{};
  ASSERT_EQ(choose(pictures.target(), fitted, texture, {}, choice), SELVAGE_OK);
  EXPECT_EQ(choice.method, SELVAGE_METHOD_COPY);
  ASSERT_EQ(choose(pictures.target(), fitted, texture, {}, choice, Rect{0, 0, 0, 0}), SELVAGE_OK);
  EXPECT_EQ(choice.method, SELVAGE_METHOD_NONE);
  ASSERT_EQ(draw(pictures.target(), fitted, texture), SELVAGE_OK);
  EXPECT_EQ(pictures.pixels[3], 3U);
  EXPECT_EQ(pictures.pixels[3 * kSide_px], 3U * kSide_texel);
}

TEST(Face, TellsOfKernelsAndScratchMemory) {
  EXPECT_TRUE(has_kernel(SELVAGE_KERNEL_SCALAR));
  EXPECT_FALSE(has_kernel(99));
  EXPECT_EQ(draw_many_bytes(7), selvage_draw_many_bytes(7));
}

TEST(Face, NoOptionsAreAllZero) {
  Pictures without, zero, tolerant;
  auto v = snapped_triangle();
  for (Vertex& vertex : v) vertex.u -= 20 * SELVAGE_SUBTEXELS;  // clamped, not wrapped
  for (int32_t i = 0; i < kSide_texel * kSide_texel; ++i) {
    without.texels[static_cast<size_t>(i)] = static_cast<uint32_t>(i % kSide_texel);
  }
  const Texture texture = without.texture();
  const Image target = without.target();
  ASSERT_EQ(selvage_draw(&target, nullptr, v.data(), v.size(), &texture, nullptr), SELVAGE_OK);
  ASSERT_EQ(draw(zero.target(), v, texture, Options{}), SELVAGE_OK);
  EXPECT_EQ(without.pixels, zero.pixels);
  const Options generous{SELVAGE_PROFILE_EXACT, SELVAGE_FILTER_NEAREST, SELVAGE_ADDRESS_CLAMP,
                         SELVAGE_SUBTEXELS, SELVAGE_KERNEL_FASTEST};
  ASSERT_EQ(draw(tolerant.target(), v, texture, generous), SELVAGE_OK);
  EXPECT_EQ(without.pixels, tolerant.pixels);
}

// Options, target, texture, both, vertices: each error hides the later ones.
TEST(Face, TheFirstErrorIsTheOneReported) {
  Pictures pictures;
  Image target = pictures.target();
  Texture texture = pictures.texture();
  auto v = snapped_triangle();
  Options options{4, 4, 2, -1, 6};
  target.format = 9, target.width = 0, target.pitch = 3;
  texture.format = 9, texture.width = 0, texture.pitch = 3;
  v[2].q = 0;
  const auto status = [&] { return draw(target, v, texture, options); };
  EXPECT_EQ(status(), SELVAGE_ERROR_PROFILE);
  options.profile = SELVAGE_PROFILE_EXACT;
  EXPECT_EQ(status(), SELVAGE_ERROR_FILTER);
  options.filter = SELVAGE_FILTER_AREA;
  options.profile = SELVAGE_PROFILE_DKIT;
  EXPECT_EQ(status(), SELVAGE_ERROR_ADDRESS);
  options.address = SELVAGE_ADDRESS_CLAMP;
  EXPECT_EQ(status(), SELVAGE_ERROR_TOLERANCE);
  options.tolerance = 0;
  EXPECT_EQ(status(), SELVAGE_ERROR_KERNEL);
  options.kernel = SELVAGE_KERNEL_FASTEST;
  EXPECT_EQ(status(), SELVAGE_ERROR_FILTER_PROFILE);
  options.profile = SELVAGE_PROFILE_EXACT;
  EXPECT_EQ(status(), SELVAGE_ERROR_TARGET_FORMAT);
  target.format = SELVAGE_RGBA8888;
  EXPECT_EQ(status(), SELVAGE_ERROR_TARGET_SIZE);
  target.width = kSide_px;
  EXPECT_EQ(status(), SELVAGE_ERROR_TARGET_PITCH);
  target.pitch = kSide_px * 4;
  EXPECT_EQ(status(), SELVAGE_ERROR_TEXTURE_FORMAT);
  texture.format = SELVAGE_INDEX8;
  EXPECT_EQ(status(), SELVAGE_ERROR_TEXTURE_SIZE);
  texture.width = kSide_texel;
  EXPECT_EQ(status(), SELVAGE_ERROR_TEXTURE_PITCH);
  texture.pitch = kSide_texel * 4;
  EXPECT_EQ(status(), SELVAGE_ERROR_FORMAT_MISMATCH);
  texture.format = SELVAGE_RGBA8888;
  EXPECT_EQ(status(), SELVAGE_ERROR_VERTEX_Q);
  target.format = texture.format = SELVAGE_INDEX8;
  EXPECT_EQ(status(), SELVAGE_ERROR_FILTER_FORMAT);
  options.filter = SELVAGE_FILTER_NEAREST;
  EXPECT_EQ(status(), SELVAGE_ERROR_VERTEX_Q);
  v[2].q = 1;
  EXPECT_EQ(status(), SELVAGE_OK);
}

}  // namespace
}  // namespace selvage
