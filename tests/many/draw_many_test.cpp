// selvage_draw_many draws what selvage_draw does, whatever the number of threads.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <optional>

#include "selvage.hpp"
#include "support.h"

namespace selvage::many {
namespace {

inline constexpr int32_t kThreads[] = {0, 1, 2, 3, 8, 100, INT32_MAX};

[[nodiscard]] Target in_turn(const List& list, const selvage_rect* clip,
                             const selvage_options& options) {
  Target target;
  const selvage_image image = target.image();
  for (const auto& [vertices, count, texture] : list.polygons) {
    EXPECT_EQ(selvage_draw(&image, clip, vertices, count, texture, &options), SELVAGE_OK);
  }
  return target;
}

void expect_same(const List& list, const selvage_rect* clip, const selvage_options& options) {
  const Target expected = in_turn(list, clip, options);
  for (const int32_t threads : kThreads) {
    Target target;
    Scratch scratch(list.polygons.size());
    const selvage_image image = target.image();
    size_t failed = 77;
    EXPECT_EQ(selvage_draw_many(&image, clip, list.polygons.data(), list.polygons.size(), &options,
                                threads, scratch.memory.data(), scratch.bytes, &failed),
              SELVAGE_OK);
    EXPECT_TRUE(target == expected) << threads << " threads";
    EXPECT_TRUE(scratch.guard_is_intact());
    EXPECT_EQ(failed, 77U);
  }
}

TEST(DrawMany, DrawsAsOneAfterAnother) {
  for (const size_t count : {1U, 2U, 30U, 500U, 3000U}) {
    for (const selvage_profile profile : {0, 1, 2, 3}) {
      const List list(count, /*seed=*/count, profile != SELVAGE_PROFILE_EXACT);
      expect_same(list, nullptr, {profile, 0, SELVAGE_ADDRESS_WRAP, 0, 0});
    }
  }
}

TEST(DrawMany, DrawsTrianglesThatShowTheTextureAsItIs) {
  List list(500, /*seed=*/6);
  for (size_t i = 0; i < list.vertices.size(); ++i) {
    selvage_vertex& vertex = list.vertices[i];
    if (i / 3 % 3 == 0) continue;
    vertex.u = vertex.x * (SELVAGE_SUBTEXELS / SELVAGE_SUBPIXELS);
    vertex.v = vertex.y * (SELVAGE_SUBTEXELS / SELVAGE_SUBPIXELS);
  }
  expect_same(list, nullptr, {});
}

TEST(DrawMany, DrawsTrianglesWithoutAreaAsOneAfterAnother) {
  List list(500, /*seed=*/7);
  for (size_t i = 2; i < list.vertices.size(); i += 6) list.vertices[i] = list.vertices[i - 1];
  expect_same(list, nullptr, {});
}

TEST(DrawMany, ClipsAll) {
  const List list(200, /*seed=*/3);
  for (const selvage_rect& clip :
       {selvage_rect{10, 20, 100, 250}, selvage_rect{-5, 100, 999, 101},
        selvage_rect{50, 50, 50, 90}, selvage_rect{0, 90, 9, 20}, selvage_rect{0, 0, 64, INT32_MIN},
        selvage_rect{INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN}}) {
    expect_same(list, &clip, {});
  }
}

TEST(DrawMany, LeavesItsArgumentsAlone) {
  List list(1500, /*seed=*/4);
  const auto vertices = list.vertices;
  const auto texels = list.texels;
  std::vector<selvage_polygon> polygons = list.polygons;
  Target target;
  Scratch scratch(polygons.size());
  ASSERT_EQ(draw_many(target.image(), list.polygons, {scratch.memory.data(), scratch.bytes}),
            SELVAGE_OK);
  EXPECT_EQ(
      std::memcmp(vertices.data(), list.vertices.data(), vertices.size() * sizeof vertices[0]), 0);
  EXPECT_EQ(texels, list.texels);
  EXPECT_EQ(
      std::memcmp(polygons.data(), list.polygons.data(), polygons.size() * sizeof polygons[0]), 0);
}

TEST(DrawMany, HasACppFaceThatPassesAllOn) {
  const List list(40, /*seed=*/5);
  const selvage_rect clip{20, 20, 90, 200};
  const selvage_options options{0, 0, SELVAGE_ADDRESS_WRAP, 0, 0};
  Target target;
  Scratch scratch(list.polygons.size());
  const std::span<std::byte> memory{scratch.memory.data(), scratch.bytes};
  ASSERT_EQ(draw_many(target.image(), list.polygons, memory, options, clip, 2), SELVAGE_OK);
  EXPECT_TRUE(target == in_turn(list, &clip, options));
  size_t failed = 0;
  std::vector<selvage_polygon> polygons = list.polygons;
  polygons[7].count = 2;
  EXPECT_EQ(draw_many(target.image(), polygons, memory, options, clip, 2, &failed),
            SELVAGE_ERROR_VERTEX_COUNT);
  EXPECT_EQ(failed, 7U);
  EXPECT_EQ(draw_many(target.image(), polygons, memory, options, clip, -1), SELVAGE_ERROR_THREADS);
}

TEST(DrawMany, NoPolygonsNeedNothing) {
  Target target;
  const Target before = target;
  const selvage_image image = target.image();
  EXPECT_EQ(selvage_draw_many_bytes(0), 0U);
  EXPECT_EQ(selvage_draw_many(&image, nullptr, nullptr, 0, nullptr, 0, nullptr, 0, nullptr),
            SELVAGE_OK);
  EXPECT_TRUE(target == before);
}

// A target in the rows of a larger bitmap whose other columns are the texture.
TEST(DrawMany, DrawsFromAnAtlasThatHoldsTheTarget) {
  std::vector<uint32_t> together(200 * 300), apart;
  for (size_t i = 0; i < together.size(); ++i) together[i] = static_cast<uint32_t>(i);
  apart = together;
  const auto image = [](std::vector<uint32_t>& pixels) {
    return selvage_image{pixels.data(), 100, 300, 200 * 4, SELVAGE_RGBA8888};
  };
  const auto texture = [](const std::vector<uint32_t>& pixels) {
    return selvage_texture{pixels.data() + 100, 100, 300, 200 * 4, SELVAGE_RGBA8888, 0, nullptr};
  };
  const selvage_vertex quad[] = {
      {0, 0, 0, 0, 1}, {25600, 500, 100 << 16, 0, 1}, {25000, 76800, 100 << 16, 300 << 16, 1}};
  const selvage_image target_apart = image(apart), target_together = image(together);
  const selvage_texture texture_apart = texture(apart), texture_together = texture(together);
  ASSERT_EQ(selvage_draw(&target_apart, nullptr, quad, 3, &texture_apart, nullptr), SELVAGE_OK);
  const selvage_polygon polygon{quad, 3, &texture_together};
  Scratch scratch(1);
  ASSERT_EQ(selvage_draw_many(&target_together, nullptr, &polygon, 1, nullptr, 2,
                              scratch.memory.data(), scratch.bytes, nullptr),
            SELVAGE_OK);
  EXPECT_EQ(together, apart);
}

}  // namespace
}  // namespace selvage::many
