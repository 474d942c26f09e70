// Lists of small polygons, drawn together and one after another.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "selvage.h"
#include "spec/canvas.h"
#include "spec/case.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {

using SmallOutline = spec::Vertices;

[[nodiscard]] inline const selvage_rect* clip_of(const spec::Case& c) {
  return c.has_clip ? &c.clip : nullptr;
}
// By what a list is drawn, beside its case.
struct DrawnBy {
  selvage_kernel kernel = SELVAGE_KERNEL_SCALAR;
  int32_t threads = 1;
  int32_t tolerance = 0;

  [[nodiscard]] selvage_options options(const spec::Case& c) const {
    return {c.profile, c.filter, c.address, tolerance, kernel};
  }
};

// As a case says, but of these outlines.
[[nodiscard]] inline spec::Canvas draw_each(const spec::Case& c, const selvage_texture& texture,
                                            const std::vector<SmallOutline>& outlines,
                                            const DrawnBy& by = {}) {
  spec::Canvas target = target_of(c);
  const selvage_image image = target.image();
  const selvage_options options = by.options(c);
  for (const SmallOutline& outline : outlines) {
    EXPECT_EQ(selvage_draw(&image, clip_of(c), outline.data(), outline.size(), &texture, &options),
              SELVAGE_OK);
  }
  return target;
}
[[nodiscard]] inline spec::Canvas draw_together(const spec::Case& c, const selvage_texture& texture,
                                                const std::vector<SmallOutline>& outlines,
                                                const DrawnBy& by) {
  spec::Canvas target = target_of(c);
  const selvage_image image = target.image();
  const selvage_options options = by.options(c);
  std::vector<selvage_polygon> polygons;
  for (const SmallOutline& outline : outlines) {
    polygons.push_back({outline.data(), outline.size(), &texture});
  }
  const size_t bytes = selvage_draw_many_bytes(polygons.size());
  std::vector<std::max_align_t> scratch(bytes / sizeof(std::max_align_t) + 1);
  EXPECT_EQ(selvage_draw_many(&image, clip_of(c), polygons.data(), polygons.size(), &options,
                              by.threads, scratch.data(), bytes, nullptr),
            SELVAGE_OK);
  return target;
}

// Fatal where some kernel draws the list otherwise than the scalar one draws its outlines in turn.
inline void expect_list_drawn_alike(const spec::Case& c, const std::vector<SmallOutline>& outlines,
                                    uint64_t seed) {
  const spec::TextureMemory texture = texture_of(c);
  const spec::Canvas one_by_one = draw_each(c, texture.view(), outlines);
  for (const selvage_kernel kernel : usable_kernels()) {
    for (const int32_t threads : {1, 3}) {
      ASSERT_TRUE(draw_together(c, texture.view(), outlines, {kernel, threads}) == one_by_one)
          << "kernel " << kernel << ", " << threads << " threads, seed " << seed << "\n"
          << spec::print(c);
    }
  }
}

// How much of each vertex a point of a triangle has, times the doubled area: all of them positive
// inside.
struct Weights {
  int64_t of[3];

  [[nodiscard]] int64_t sum() const { return of[0] + of[1] + of[2]; }
  [[nodiscard]] bool are_inside() const { return of[0] > 0 && of[1] > 0 && of[2] > 0; }
  // Or on an edge of what has an area.
  [[nodiscard]] bool touch() const { return of[0] >= 0 && of[1] >= 0 && of[2] >= 0 && sum() > 0; }
};

[[nodiscard]] inline Weights weights_at(std::span<const selvage_vertex> triangle, int32_t x_fx8,
                                        int32_t y_fx8) {
  const auto doubled_area = [&](size_t from, size_t to) {
    const int64_t ax = triangle[from].x - x_fx8, ay = triangle[from].y - y_fx8;
    const int64_t bx = triangle[to].x - x_fx8, by = triangle[to].y - y_fx8;
    return ax * by - ay * bx;
  };
  Weights weights{{doubled_area(1, 2), doubled_area(2, 0), doubled_area(0, 1)}};
  if (weights.sum() < 0) {
    for (int64_t& weight : weights.of) weight = -weight;
  }
  return weights;
}

// b with a b = 1 modulo m, or 0 where there is none: Euclid's algorithm.
[[nodiscard]] inline int64_t inverse(int64_t a, int64_t m) {
  int64_t rest = m, other = a % m, factor = 0, other_factor = 1;
  while (other != 0) {
    const int64_t quotient = rest / other;
    std::swap(rest -= quotient * other, other);
    std::swap(factor -= quotient * other_factor, other_factor);
  }
  return rest == 1 ? (factor + m) % m : 0;
}

}  // namespace selvage::mapper
