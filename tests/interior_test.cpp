// The interior of a row: all of its pixels have their four texels in the texture, and few that have
// are missed.
#include "mapper/interior.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "spec/random.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {
namespace {

inline constexpr int64_t kHalf_fx32 = int64_t{1} << (kLaneFraction - 1);
inline constexpr int32_t kMostLost_px = 3;  // at each end

// Of one coordinate: neither the lane nor what it may lack leaves [1/2, size - 1/2).
[[nodiscard]] bool is_coordinate_inside(int64_t lane_fx32, int32_t size_texel,
                                        uint32_t margin_fx32) {
  const int64_t from_first_fx32 = lane_fx32 - kHalf_fx32;
  return 0 <= from_first_fx32 && from_first_fx32 + margin_fx32 < int64_t{size_texel - 1}
                                                                     << kLaneFraction;
}

struct TexturedRow {
  AffineField field;
  selvage_texture texture;
  Span span;

  [[nodiscard]] bool holds(int32_t px) const {
    const Lane lane = field.at(px, span.row);
    return is_coordinate_inside(lane.u_fx32, texture.width, field.margin_fx32) &&
           is_coordinate_inside(lane.v_fx32, texture.height, field.margin_fx32);
  }
};

[[nodiscard]] TexturedRow any_textured_row(spec::Random& random, selvage_layout layout) {
  const auto size = [&] { return random.pick({1, 2, 3, random.in(2, 40), random.in(2, 32769)}); };
  const auto step_fx32 = [&]() -> int64_t {
    const int64_t unit = int64_t{1} << random.in(0, 36);
    return random.pick({-1, 0, 1, 1, 3}) * unit + random.in(-1, 2);
  };
  const selvage_texture texture{nullptr, size(), size(), 0, SELVAGE_RGBA8888, layout, nullptr};
  const auto start_fx32 = [&](int32_t size_texel) -> int64_t {
    const int32_t texel = random.pick({0, -1, size_texel - 1, random.in(-50, size_texel + 50)});
    return (int64_t{texel} << kLaneFraction) + random.pick({int64_t{0}, kHalf_fx32}) +
           random.in(-2, 3);
  };
  const int32_t left_px = random.in(-4, 5), row = random.in(-4, 5);
  const uint32_t margin_fx32 = random.pick({1U, 40U, 131072U});
  const Lane start{start_fx32(texture.width), start_fx32(texture.height)};
  const AffineField field{left_px, row, start, {step_fx32(), step_fx32()}, {1, -1}, margin_fx32};
  return {field, texture, {row, left_px, left_px + random.in(1, 400)}};
}

TEST(Interior, HoldsPixelsThatAreInsideAndMissesFew) {
  spec::Random random(5);
  int64_t inside_px = 0;
  for (int i = 0; i < 20000; ++i) {
    const TexturedRow row = any_textured_row(random, SELVAGE_LAYOUT_ROWS);
    const Span& span = row.span;
    const Span inner = Interior(row.field, row.texture).of(span);
    ASSERT_EQ(inner.row, span.row);
    ASSERT_LE(span.left_px, inner.left_px) << i;
    ASSERT_LE(inner.left_px, inner.right_px) << i;
    ASSERT_LE(inner.right_px, span.right_px) << i;
    for (int32_t px = inner.left_px; px < inner.right_px; ++px) ASSERT_TRUE(row.holds(px)) << i;
    int32_t before_px = 0, behind_px = 0;
    for (int32_t px = span.left_px; px < span.right_px; ++px) {
      if (inner.left_px <= px && px < inner.right_px) continue;
      (px < inner.left_px ? before_px : behind_px) += row.holds(px) ? 1 : 0;
    }
    ASSERT_LE(before_px, inner.empty() ? 2 * kMostLost_px : kMostLost_px) << i;
    ASSERT_LE(behind_px, inner.empty() ? 2 * kMostLost_px : kMostLost_px) << i;
    inside_px += inner.width_px();
  }
  EXPECT_GT(inside_px, 200000);
}

// Of all rows of a batch: each pixel shows a texel of the texture, or the end of some row may not.
template <class Field, class LaneAt>
void expect_told(const SpanBatch& batch, const Field& field, const selvage_texture& texture,
                 uint32_t margin_fx32, const LaneAt& lane_at, int* inside) {
  const auto within = [&](int64_t lane_fx32, int32_t size_texel) {
    return lane_fx32 >= 0 && lane_fx32 + margin_fx32 < int64_t{size_texel} << kLaneFraction;
  };
  bool all = true;
  for (int32_t i = 0; i < batch.rows; ++i) {
    const Span span = batch.span(i);
    for (int32_t px = span.left_px; px < span.right_px; ++px) {
      const Lane lane = lane_at(span, px);
      all = all && within(lane.u_fx32, texture.width) && within(lane.v_fx32, texture.height);
    }
  }
  ASSERT_EQ(is_inside(batch, field, texture), all);
  *inside += all ? 1 : 0;
}

// Rows of one to 60 pixels, or none, from a row's first pixel on.
[[nodiscard]] SpanBatch any_batch_from(const TexturedRow& row, spec::Random& random) {
  SpanBatch batch;
  batch.first_row = row.span.row;
  batch.rows = random.in(1, 5);
  batch.widest_px = 0;
  for (size_t i = 0; i < static_cast<size_t>(batch.rows); ++i) {
    batch.left_px[i] = row.span.left_px + random.in(0, 3);
    batch.right_px[i] = batch.left_px[i] + (random.percent(20) ? 0 : random.in(1, 60));
    batch.widest_px = std::max(batch.widest_px, batch.right_px[i] - batch.left_px[i]);
  }
  return batch;
}

TEST(Inside, IsToldOfAffineRowsAsTheirPixelsTellIt) {
  spec::Random random(7);
  int inside = 0;
  for (int i = 0; i < 20000; ++i) {
    const TexturedRow row = any_textured_row(random, SELVAGE_LAYOUT_ROWS);
    SCOPED_TRACE(i);
    ASSERT_NO_FATAL_FAILURE(expect_told(
        any_batch_from(row, random), row.field, row.texture, row.field.margin_fx32,
        [&](const Span& span, int32_t px) { return row.field.at(px, span.row); }, &inside));
  }
  EXPECT_GT(inside, 2000);
  EXPECT_LT(inside, 18000);
}

// A lane and all that it may lack reach the texture's end, in u or in v, or a unit less.
TEST(Inside, EndsBeforeTheTextureDoes) {
  constexpr uint32_t kMargin_fx32 = 40;
  const selvage_texture texture{nullptr, 5, 9, 0, SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
  const Lane ends{int64_t{5} << kLaneFraction, int64_t{9} << kLaneFraction};
  const SpanBatch pixel = one_span({0, 0, 1});
  const auto is_told = [&](int64_t before_u_fx32, int64_t before_v_fx32) {
    const Lane lane{ends.u_fx32 - kMargin_fx32 - before_u_fx32,
                    ends.v_fx32 - kMargin_fx32 - before_v_fx32};
    return is_inside(pixel, AffineField{0, 0, lane, {}, {}, kMargin_fx32}, texture);
  };
  EXPECT_TRUE(is_told(1, 1));
  EXPECT_FALSE(is_told(0, 1));
  EXPECT_FALSE(is_told(1, 0));
}

// A row that is inside from end to end loses nothing at its start.
TEST(Interior, IsTheWholeRowWhereThatIsFarFromEachSide) {
  const selvage_texture texture{nullptr, 500, 500, 0, SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS,
                                nullptr};
  const int64_t middle_fx32 = int64_t{250} << kLaneFraction;
  for (const int64_t step_fx32 : {int64_t{0}, int64_t{1} << kLaneFraction, -int64_t{1} << 30}) {
    const AffineField field{3, 7, {middle_fx32, middle_fx32}, {step_fx32, -step_fx32}, {}, 100};
    const Span inner = Interior(field, texture).of({7, 3, 103});
    EXPECT_EQ(inner.left_px, 3);
    EXPECT_EQ(inner.right_px, 103);
  }
}

TEST(Interior, IsEmptyInTiles) {
  spec::Random random(6);
  for (int i = 0; i < 100; ++i) {
    const TexturedRow row = any_textured_row(random, SELVAGE_LAYOUT_TILES);
    EXPECT_TRUE(Interior(row.field, row.texture).of(row.span).empty());
  }
}

// u or v so close to the middle of the only texel, for so long, that lanes lack more than a row of
// pixels changes. What is beside the texel is of another colour.
TEST(Interior, IsEmptyWhereTheTextureIsOneTexelWideOrHigh) {
  constexpr int32_t kWidth_px = 4000, kHeight_px = 2, kPitch_texel = 4, kMiddle_fx16 = 1 << 15;
  constexpr uint32_t kUntouched = 0x5A5A5A5A;
  std::vector<uint32_t> memory(64, 0xFFFFFFFF);
  for (const bool wide : {false, true}) {
    const int32_t width = wide ? 3 : 1, height = wide ? 1 : 3;
    uint32_t* const texels = memory.data() + 24;
    for (int32_t t = 0; t < height; ++t) std::fill_n(texels + t * kPitch_texel, width, 0);
    const selvage_texture texture{
        texels, width, height, kPitch_texel * 4, SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
    const auto corner = [&](int32_t x_px, int32_t y_px, int32_t beside_fx16) {
      const int32_t near_fx16 = kMiddle_fx16 + beside_fx16, far_fx16 = 3 << 15;
      return selvage_vertex{x_px * SELVAGE_SUBPIXELS, y_px * SELVAGE_SUBPIXELS,
                            wide ? far_fx16 : near_fx16, wide ? near_fx16 : far_fx16, 1};
    };
    const std::array<selvage_vertex, 3> triangle{corner(0, 0, -6), corner(kWidth_px, 0, 6),
                                                 corner(0, kWidth_px, -6)};
    for (const selvage_filter filter : {SELVAGE_FILTER_FOUR, SELVAGE_FILTER_BILINEAR}) {
      for (const selvage_kernel kernel : usable_kernels()) {
        std::vector<uint32_t> pixels(kWidth_px * kHeight_px, kUntouched);
        const selvage_image target{pixels.data(), kWidth_px, kHeight_px, kWidth_px * 4,
                                   SELVAGE_RGBA8888};
        const selvage_options options{SELVAGE_PROFILE_EXACT, filter, SELVAGE_ADDRESS_CLAMP, 0,
                                      kernel};
        ASSERT_EQ(selvage_draw(&target, nullptr, triangle.data(), 3, &texture, &options),
                  SELVAGE_OK);
        const auto drawn = std::ranges::count(pixels, 0U);
        EXPECT_EQ(drawn + std::ranges::count(pixels, kUntouched), kWidth_px * kHeight_px)
            << "kernel " << kernel << ", filter " << filter;
        EXPECT_GE(drawn, kWidth_px * kHeight_px - 2 * kHeight_px);
      }
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
