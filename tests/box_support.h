// Boxes of the area filter along a line, as a kernel draws them.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mapper/channels.h"
#include "mapper/filter_box.h"
#include "mapper/vector/kernel.h"
#include "spec/random.h"
#include "tests/span_support.h"

namespace selvage::mapper {

[[nodiscard]] inline selvage_texture in_rows(const std::vector<uint32_t>& texels, int32_t width) {
  return {texels.data(),
          width,
          static_cast<int32_t>(texels.size() / static_cast<size_t>(width)),
          ptrdiff_t{4} * width,
          SELVAGE_RGBA8888,
          SELVAGE_LAYOUT_ROWS,
          nullptr};
}

// Boxes of these sides along a line of points, which lanes hit exactly.
struct BoxLine {
  FilterPoint start, step;
  BoxSides sides;
};

[[nodiscard]] inline Box box_of(const BoxLine& line, int32_t i) {
  return Box::around(
      {line.start.u_fx8 + i * line.step.u_fx8, line.start.v_fx8 + i * line.step.v_fx8}, line.sides);
}

[[nodiscard]] inline std::vector<uint32_t> drawn_boxes(const BoxLine& line, int32_t count,
                                                       const selvage_texture& texture,
                                                       selvage_address address,
                                                       selvage_kernel kernel) {
  std::vector<uint32_t> pixels(static_cast<size_t>(count) + 1, 0x5A5A5A5A);
  const selvage_image target{pixels.data(), count + 1, 1, 4 * (ptrdiff_t{count} + 1),
                             SELVAGE_RGBA8888};
  const Surface surface{target, texture, address};
  const auto lane = [](int32_t point_fx8) { return int64_t{point_fx8} * (1 << kGridFraction); };
  constexpr int64_t kHalf_fx32 = int64_t{1} << (kLaneFraction - 1);
  const AffineField field{
      0,
      0,
      {lane(line.start.u_fx8) + kHalf_fx32, lane(line.start.v_fx8) + kHalf_fx32},
      {lane(line.step.u_fx8), lane(line.step.v_fx8)},
      {},
      0};
  const SpanMap unused(EdgePoint{1, 0, 0, 0, 1}, EdgePoint{1, 256, 0, 0, 1});
  const SpanBatch batch = one_span({0, 0, count});
  const Kernels* const kernels = kernel == SELVAGE_KERNEL_SCALAR
                                     ? &scalar_kernels(SELVAGE_FILTER_AREA)
                                     : vector_kernels(kernel, SELVAGE_FILTER_AREA);
  kernels->draw_boxes_affine({batch, field, kFarApart, ExactMap(unused)}, line.sides, surface);
  EXPECT_EQ(pixels.back(), 0x5A5A5A5AU) << "beyond the span";
  pixels.pop_back();
  return pixels;
}

[[nodiscard]] inline std::vector<uint32_t> noise_texels(spec::Random& random, int32_t texels) {
  std::vector<uint32_t> noise;
  const bool extreme = random.percent(30);  // 0 and 255 only, mostly 255
  for (int32_t i = 0; i < texels; ++i) {
    uint32_t texel = 0;
    for (int k = 0; k < 4; ++k) {
      const auto any = static_cast<uint32_t>(random.in(0, 256));
      texel = texel << 8 | (extreme ? (any < 250 ? 255 : 0) : any);
    }
    noise.push_back(texel);
  }
  return noise;
}

}  // namespace selvage::mapper
