#include "mapper/row_kernel.h"

#include <gtest/gtest.h>

#include <vector>

#include "spec/picture.h"
#include "tests/span_support.h"

namespace selvage::mapper {
namespace {

// A span from x = 1 to x = 5 over u = `first` .. `first` + 4 texels, v = 0.
[[nodiscard]] SpanMap one_to_one(int32_t first_texel) {
  const auto at = [](int32_t x_px, int32_t u_texel) {
    return EdgePoint{.height = 256,
                     .x = int64_t{x_px} * 256 * 256,
                     .uq = int128{u_texel} * 65536 * 256,
                     .vq = 0,
                     .q = 256};
  };
  return {at(1, first_texel), at(5, first_texel + 4)};
}

template <class Pixel>
[[nodiscard]] std::vector<Pixel> drawn(selvage_format format, selvage_address address,
                                       int32_t first_texel, bool affine) {
  const std::vector<Pixel> texels = {10, 11, 12};
  std::vector<Pixel> row(7, 99);
  const selvage_texture texture{texels.data(), 3, 1, 3 * sizeof(Pixel), format, 0, nullptr};
  const SpanMap map = one_to_one(first_texel);
  const Span span{0, 1, 5};
  if (affine) {
    affine_row_kernel(format)(AffineLanes(map, span), ExactTexel(map), span, texture, address,
                              row.data());
  } else {
    projective_row_kernel(format)(ProjectiveLanes(map, span), ExactTexel(map), span, texture,
                                  address, row.data());
  }
  return row;
}

template <class Pixel>
void expect_rows(selvage_format format) {
  using Row = std::vector<Pixel>;
  for (const bool affine : {false, true}) {
    EXPECT_EQ(drawn<Pixel>(format, SELVAGE_ADDRESS_CLAMP, -1, affine),
              (Row{99, 10, 10, 11, 12, 99, 99}));
    EXPECT_EQ(drawn<Pixel>(format, SELVAGE_ADDRESS_CLAMP, 0, affine),
              (Row{99, 10, 11, 12, 12, 99, 99}));
    EXPECT_EQ(drawn<Pixel>(format, SELVAGE_ADDRESS_WRAP, -1, affine),
              (Row{99, 12, 10, 11, 12, 99, 99}));
    EXPECT_EQ(drawn<Pixel>(format, SELVAGE_ADDRESS_WRAP, -302, affine),
              (Row{99, 11, 12, 10, 11, 99, 99}));
  }
}

TEST(RowKernel, WritesItsSpanAndNothingElse) {
  expect_rows<uint8_t>(SELVAGE_INDEX8);
  expect_rows<uint16_t>(SELVAGE_RGB565);
  expect_rows<uint32_t>(SELVAGE_RGBA8888);
}

}  // namespace
}  // namespace selvage::mapper
