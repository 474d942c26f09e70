// A list of polygons with all that they refer to, and pictures to draw them on.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "selvage.h"
#include "spec/random.h"

namespace selvage::many {

inline constexpr int32_t kWidth_px = 130, kHeight_px = 301;

// Small ones and some that cross all rows, over each other and over the borders, of two textures.
struct List {
  std::vector<uint32_t> texels;
  selvage_texture textures[2];
  std::vector<selvage_vertex> vertices;
  std::vector<selvage_polygon> polygons;

  List(size_t count, uint64_t seed, bool whole_px = false) : texels(2 * 32 * 32) {
    spec::Random random(seed);
    for (uint32_t& texel : texels) texel = static_cast<uint32_t>(random.bits());
    for (size_t i = 0; i < 2; ++i) {
      textures[i] = {texels.data() + i * 32 * 32, 32,     32, 32 * 4, SELVAGE_RGBA8888,
                     SELVAGE_LAYOUT_ROWS,         nullptr};
    }
    for (size_t i = 0; i < 3 * count; ++i) vertices.push_back(vertex(random, i, whole_px));
    for (size_t i = 0; i < count; ++i) {
      polygons.push_back({vertices.data() + 3 * i, 3, &textures[random.below(2)]});
    }
  }
  List(const List&) = delete;
  List& operator=(const List&) = delete;

 private:
  // Vertices of a triangle lie about its first one.
  selvage_vertex vertex(spec::Random& random, size_t index, bool whole_px) {
    selvage_vertex v{random.in(-20 * 256, (kWidth_px + 20) * 256),
                     random.in(-20 * 256, (kHeight_px + 20) * 256), random.in(0, 40 << 16),
                     random.in(0, 40 << 16), 1};
    if (index % 3 != 0 && index / 3 % 50 != 0) {
      const selvage_vertex& first = vertices[index / 3 * 3];
      v.x = first.x + random.in(-4000, 4001);
      v.y = first.y + random.in(-4000, 4001);
    }
    if (whole_px) v.x &= ~255, v.y &= ~255;
    return v;
  }
};

struct Target {
  std::vector<uint32_t> pixels = std::vector<uint32_t>(kWidth_px * kHeight_px, 0x55555555);

  [[nodiscard]] selvage_image image() {
    return {pixels.data(), kWidth_px, kHeight_px, kWidth_px * 4, SELVAGE_RGBA8888};
  }
  friend bool operator==(const Target&, const Target&) = default;
};

// As aligned as malloc's memory, with a guard behind it.
struct Scratch {
  static constexpr size_t kGuardBytes = 64;
  size_t bytes;
  std::vector<std::byte> memory;

  explicit Scratch(size_t polygons)
      : bytes(selvage_draw_many_bytes(polygons)), memory(bytes + kGuardBytes, std::byte{0xA5}) {}
  [[nodiscard]] bool guard_is_intact() const {
    for (size_t i = bytes; i < memory.size(); ++i) {
      if (memory[i] != std::byte{0xA5}) return false;
    }
    return true;
  }
};

// By one call.
[[nodiscard]] inline Target drawn(const List& list, int32_t threads) {
  Target target;
  Scratch scratch(list.polygons.size());
  const selvage_image image = target.image();
  EXPECT_EQ(selvage_draw_many(&image, nullptr, list.polygons.data(), list.polygons.size(), nullptr,
                              threads, scratch.memory.data(), scratch.bytes, nullptr),
            SELVAGE_OK);
  return target;
}

}  // namespace selvage::many
