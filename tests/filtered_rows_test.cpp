// Filtered rows that are longer than the pieces they are drawn in, and that leave the texture on
// both sides: against the model, pixel for pixel.
#include <gtest/gtest.h>

#include <array>
#include <tuple>

#include "mapper/kernel_choice.h"
#include "spec/picture.h"

namespace selvage {
namespace {

using spec::Case;

inline constexpr int32_t kTwoPieces_px = 301;  // the last one of odd length

// u runs over the texture and beyond it on both sides, `texels_per_px` a pixel; q goes
// from `far` to the greatest.
[[nodiscard]] Case row(selvage_filter filter, selvage_address address, int32_t texels_per_px,
                       int32_t far) {
  Case c;
  c.filter = filter;
  c.address = address;
  c.target_width_px = kTwoPieces_px;
  c.target_height_px = 1;
  c.texture_width_texel = 200 * texels_per_px - 23;
  c.texture_height_texel = 5;
  constexpr int32_t kRight = kTwoPieces_px * SELVAGE_SUBPIXELS - 77;
  const int32_t left_u = -60 * texels_per_px * SELVAGE_SUBTEXELS;
  const int32_t right_u = left_u + kTwoPieces_px * texels_per_px * SELVAGE_SUBTEXELS + 12345;
  c.vertices = {{0, -40, left_u, -70000, far},
                {kRight, -90, right_u, 90000, SELVAGE_Q_MAX},
                {kRight, 600, right_u, 180000, SELVAGE_Q_MAX},
                {0, 600, left_u, 260000, far}};
  return c;
}

void expect_row_as_modelled(const Case& c, selvage_kernel kernel) {
  spec::Subject subject = spec::built_in();
  subject.draw = [by = kernel](const selvage_image* target, const selvage_rect* clip,
                               const selvage_vertex* vertices, size_t count,
                               const selvage_texture* texture, const selvage_options* options) {
    selvage_options by_kernel = *options;
    by_kernel.kernel = by;
    by_kernel.tolerance = SELVAGE_SUBTEXELS;  // filters are exact whatever the tolerance
    return selvage_draw(target, clip, vertices, count, texture, &by_kernel);
  };
  const spec::Picture drawn = spec::draw(subject, c), model = spec::expected(c);
  ASSERT_EQ(drawn.status, SELVAGE_OK);
  EXPECT_EQ(drawn.memory_fault, "");
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    for (int32_t x = 0; x < c.target_width_px; ++x) {
      ASSERT_EQ(drawn.at(x, y), model.at(x, y)) << "pixel " << x << ", " << y;
    }
  }
}

using Parameters = std::tuple<selvage_filter, selvage_address, int32_t, int32_t, selvage_kernel>;
class FilteredRows : public testing::TestWithParam<Parameters> {};

TEST_P(FilteredRows, AreTheModels) {
  const auto [filter, address, texels_per_px, far, kernel] = GetParam();
  const Case c = row(filter, address, texels_per_px, far);
  expect_row_as_modelled(c, kernel);
}

// The side of a box is whole at the middle of the row, where doubles cannot tell whether it is
// more.
TEST(FilteredRow, HasBoxesOfWholeSides) {
  constexpr int32_t kHalf = 25600, kNear = 1 << 19, kCentre = 128 + kHalf;
  for (const int32_t side_fx8 : {300, 1024, 1337}) {
    for (const int32_t beyond : {-1, 0, 1}) {
      Case c;
      c.filter = SELVAGE_FILTER_AREA;
      c.address = SELVAGE_ADDRESS_WRAP;
      c.target_width_px = 200;
      c.target_height_px = 1;
      c.texture_width_texel = c.texture_height_texel = 64;
      const int32_t v = side_fx8 * (kHalf / 2 * 3), u = v + beyond;
      const int32_t top = 128 - kHalf;
      c.vertices = {{kCentre - kHalf, top, -u, -v, kNear},
                    {kCentre + kHalf, top, u, v, kNear},
                    {kCentre, top + 2 * kHalf, 0, 0, 2 * kNear}};
      for (selvage_kernel each = SELVAGE_KERNEL_SCALAR; each <= SELVAGE_KERNEL_NEON; ++each) {
        if (mapper::is_usable(each)) expect_row_as_modelled(c, each);
        ASSERT_FALSE(HasFatalFailure()) << "kernel " << each << ", side " << side_fx8;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    , FilteredRows,
    testing::Combine(testing::Values(SELVAGE_FILTER_FOUR, SELVAGE_FILTER_BILINEAR,
                                     SELVAGE_FILTER_AREA),
                     testing::Values(SELVAGE_ADDRESS_CLAMP, SELVAGE_ADDRESS_WRAP),
                     testing::Values(1, 7), testing::Values(SELVAGE_Q_MAX, 1 << 22, 1),
                     testing::Values(SELVAGE_KERNEL_SCALAR, SELVAGE_KERNEL_FASTEST)));

}  // namespace
}  // namespace selvage
