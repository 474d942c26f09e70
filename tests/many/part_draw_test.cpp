// Whenever half of a part is given away, the picture is the same.
#include "many/part_draw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <thread>
#include <vector>

#include "tests/many/prepared_list.h"

namespace selvage::many {
namespace {

// Draws what others give, until all is done.
struct Taker {
  const PreparedList& list;
  HandOver& parts;
  int drawn = 0;

  void work(size_t worker) {
    while (const std::optional<Part> part = parts.take(worker)) {
      PartDraw(list.request, list.index, &parts, *part).draw_all();
      parts.done();
      ++drawn;
    }
  }
};

enum class Others { kWaitFromTheBeginning, kComeLater };

// One worker has all. How many parts the others were given.
[[nodiscard]] int draw_with(size_t others, const PreparedList& list,
                            Others when = Others::kWaitFromTheBeginning) {
  std::vector<Part> shares(1 + others, {0, {0, 0}});
  shares[0].bands = list.all_bands();
  HandOver parts(shares);
  const std::optional<Part> all = parts.take(0);
  std::vector<Taker> takers(1 + others, {list, parts});
  std::vector<std::thread> threads;
  std::atomic<bool> begins = when == Others::kWaitFromTheBeginning;
  for (size_t i = 1; i <= others; ++i) {
    threads.emplace_back([&, i] {
      while (!begins) std::this_thread::yield();
      takers[i].work(i);
    });
  }
  if (begins) {
    while (parts.waiting() != others) std::this_thread::yield();
  }
  begins = true;
  PartDraw(list.request, list.index, &parts, all.value()).draw_all();
  parts.done();
  takers[0].work(0);
  for (std::thread& thread : threads) thread.join();
  int drawn = 0;
  for (const Taker& taker : takers) drawn += taker.drawn;
  return drawn - static_cast<int>(others);  // their own ones were empty
}

[[nodiscard]] Target in_order(std::span<const selvage_polygon> polygons,
                              const selvage_options& options) {
  Target target;
  const selvage_image image = target.image();
  for (const auto& [vertices, count, texture] : polygons) {
    EXPECT_EQ(selvage_draw(&image, nullptr, vertices, count, texture, &options), SELVAGE_OK);
  }
  return target;
}

TEST(PartDraw, DrawsTheSameHoweverItIsSharedOut) {
  for (const size_t count : {1U, 2U, 60U, 500U, 3000U}) {
    for (const selvage_profile profile : {0, 1, 2, 3}) {
      const selvage_options options{profile, 0, SELVAGE_ADDRESS_WRAP, 0, 0};
      const List list(count, /*seed=*/count, profile != SELVAGE_PROFILE_EXACT);
      const Target expected = in_order(list.polygons, options);
      for (int round = 0; round < 5; ++round) {
        Target target;
        const PreparedList prepared(list.polygons, target.image(), options);
        const int given = draw_with(1, prepared);
        ASSERT_TRUE(target == expected) << count << " polygons, profile " << profile;
        EXPECT_TRUE(given > 0 || count < 60) << count << " polygons, profile " << profile;
      }
    }
  }
}

// Small triangles in one place, each over the last one, and many to the left of the target in rows
// above: who gives the place away and keeps a triangle until those are done draws it over the last.
// A square beside the place has the last one drawn at once.
TEST(PartDraw, DrawsWhatItKeepsBeforeItGives) {
  constexpr int32_t kPx = 256;
  const List list(1, /*seed=*/1);
  std::vector<selvage_vertex> vertices;
  const auto add = [&](int32_t left_px, int32_t top_px, int32_t u_texel) {
    const int32_t x = left_px * kPx, y = top_px * kPx, u = u_texel << 16;
    vertices.insert(
        vertices.end(),
        {{x, y, u, 0, 1}, {x + 8 * kPx, y, u + (8 << 16), 0, 1}, {x, y + 8 * kPx, u, 8 << 16, 1}});
  };
  for (int i = 0; i < 2000; ++i) add(10, 250, i % 24);
  for (int i = 0; i < 20'000; ++i) add(-20, i % 240, 0);
  std::vector<selvage_polygon> polygons;
  for (size_t i = 0; i < vertices.size(); i += 3) {
    polygons.push_back({vertices.data() + i, 3, &list.textures[0]});
  }
  const std::array<selvage_vertex, 4> square{{{100 * kPx, 250 * kPx, 0, 0, 1},
                                              {108 * kPx, 250 * kPx, 0, 0, 1},
                                              {108 * kPx, 258 * kPx, 0, 0, 1},
                                              {100 * kPx, 258 * kPx, 0, 0, 1}}};
  polygons.insert(polygons.begin() + 2000, {square.data(), 4, &list.textures[0]});
  const Target expected = in_order(polygons, {});
  for (int round = 0; round < 20; ++round) {
    Target target;
    const PreparedList prepared(polygons, target.image());
    const int given = draw_with(1, prepared, Others::kComeLater);
    EXPECT_TRUE(target == expected) << given << " parts given";
  }
}

TEST(PartDraw, KeepsASingleBand) {
  const List list(300, /*seed=*/3);
  const Target expected = in_order(list.polygons, {});
  Target target;
  selvage_image strip = target.image();
  strip.height = kLeastBandRows;
  const PreparedList prepared(list.polygons, strip);
  EXPECT_EQ(draw_with(1, prepared), 0);
  EXPECT_TRUE(std::equal(target.pixels.begin(), target.pixels.begin() + kWidth_px * kLeastBandRows,
                         expected.pixels.begin()));
}

// Polygons that are drawn in pieces, on a target of a thousand pixels a side.
class LargePolygons : public testing::Test {
 protected:
  static constexpr int32_t kSide_px = 1000, kSide = kSide_px * 256;
  static inline const std::array<selvage_vertex, 4> kWhole{{{0, 0, 0, 0, 1},
                                                            {kSide, 0, 31 << 16, 0, 1},
                                                            {kSide, kSide, 31 << 16, 31 << 16, 1},
                                                            {0, kSide, 0, 31 << 16, 1}}};

  const List list{1, /*seed=*/1};
  std::vector<selvage_polygon> polygons{{kWhole.data(), 4, &list.textures[0]}};
  std::vector<uint32_t> pixels = std::vector<uint32_t>(kSide_px * kSide_px);

  [[nodiscard]] static selvage_image image(std::vector<uint32_t>& of) {
    return {of.data(), kSide_px, kSide_px, kSide_px * 4, SELVAGE_RGBA8888};
  }
  [[nodiscard]] std::vector<uint32_t> expected() const {
    std::vector<uint32_t> drawn(pixels.size());
    const selvage_image target = image(drawn);
    for (const auto& [vertices, count, texture] : polygons) {
      EXPECT_EQ(selvage_draw(&target, nullptr, vertices, count, texture, nullptr), SELVAGE_OK);
    }
    return drawn;
  }
};

TEST_F(LargePolygons, HaveOthersBehindThemInAllBands) {
  const std::array<selvage_vertex, 3> small{
      {{0, 0, 0, 0, 1}, {9 * 256, 256, 9 << 16, 0, 1}, {256, 9 * 256, 0, 9 << 16, 1}}};
  polygons.push_back({small.data(), 3, &list.textures[1]});
  static_cast<void>(draw_with(0, PreparedList(polygons, image(pixels))));
  EXPECT_EQ(pixels, expected());
}

TEST_F(LargePolygons, AreGivenAway) {
  polygons.push_back({kWhole.data(), 4, &list.textures[1]});
  EXPECT_GT(draw_with(2, PreparedList(polygons, image(pixels))), 1);
  EXPECT_EQ(pixels, expected());
}

// Who takes the last rows of one that is half drawn draws something else over it there: nobody else
// draws it once more.
TEST_F(LargePolygons, AreNotDrawnInWhatWasGivenAway) {
  constexpr int32_t kLast = kSide - 10 * 256;
  const std::array<selvage_vertex, 3> small{
      {{0, kLast, 0, 0, 1}, {9 * 256, kLast, 9 << 16, 0, 1}, {0, kSide - 256, 0, 9 << 16, 1}}};
  polygons.push_back({small.data(), 3, &list.textures[1]});
  const std::vector<uint32_t> whole = expected();
  for (int round = 0; round < 20; ++round) {
    std::fill(pixels.begin(), pixels.end(), 0);
    const int given = draw_with(1, PreparedList(polygons, image(pixels)), Others::kComeLater);
    ASSERT_EQ(pixels, whole) << given << " parts given";
  }
}

}  // namespace
}  // namespace selvage::many
