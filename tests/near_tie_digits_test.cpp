// Near-ties by vectors are signs of differences of wide products: rows whose numbers are of all
// sizes, and grow along the row, and differences down to one unit.
#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "mapper/gentle_pieces.h"
#include "mapper/vector/kernel.h"
#include "spec/random.h"
#include "tests/kernel_support.h"
#include "tests/span_support.h"

namespace selvage::mapper {
namespace {

// Next to a whole texel at both edges, and so in between.
struct NearTieRow {
  Span span;
  EdgePoint left, right;
  int32_t lag_fx32;  // affine lanes are low by so much more
};

enum class Side { kLeft, kRight };

// At the centre of a pixel of the span, or a hair or some pixels beside.
[[nodiscard]] EdgePoint edge(spec::Random& random, Side side, int32_t px, int64_t q,
                             int32_t texel) {
  const int64_t height = random.percent(30) ? 1 : int64_t{1} << random.in(0, 24);
  const int64_t beside = random.in(0, 4) * (random.percent(50) ? 1 : height);
  const int64_t scale = q * height;
  const auto near_by = [&](int32_t whole) {
    const int64_t fx16 =
        int64_t{whole} * SELVAGE_SUBTEXELS + (random.percent(50) ? 0 : random.in(-3, 4));
    const int64_t part = random.in(-1000, 1001) * scale / 1000;
    return int128{fx16} * scale + random.pick({int64_t{0}, int64_t{0}, int64_t{-1}, part});
  };
  const int64_t centre = centre_fx8(px) * height;
  return {height, side == Side::kLeft ? centre - beside : centre + 1 + beside, near_by(texel),
          near_by(texel / 2), scale};
}

[[nodiscard]] NearTieRow any_near_tie_row(uint64_t seed) {
  spec::Random random(seed);
  const int32_t width_px = random.pick({1, 1, 2, 2, 2, 3, 17, 40, 300});
  const int32_t texel = random.in(-40, 100);
  const int64_t least = int64_t{1} << random.in(0, 15);
  const int64_t most = random.percent(30) ? least : least << random.in(0, 11);
  const bool grows = random.percent(50);
  return {{0, 0, width_px},
          edge(random, Side::kLeft, 0, grows ? least : most, texel),
          edge(random, Side::kRight, width_px - 1, grows ? most : least, texel),
          random.percent(50) ? 0 : random.in(0, 1 << 17)};
}

[[nodiscard]] std::vector<uint32_t> drawn_near_ties(const NearTieRow& row, selvage_kernel kernel) {
  static const std::vector<uint32_t> texels = [] {
    std::vector<uint32_t> all(kRowTexture_texel * kRowTexture_texel);
    for (size_t i = 0; i < all.size(); ++i) all[i] = static_cast<uint32_t>(i) * 2654435761U;
    return all;
  }();
  const SpanMap map(row.left, row.right);
  const int32_t width_px = row.span.width_px();
  std::vector<uint32_t> pixels(static_cast<size_t>(width_px));
  const Surface surface{{pixels.data(), width_px, 1, width_px * 4, SELVAGE_RGBA8888},
                        {texels.data(), kRowTexture_texel, kRowTexture_texel, kRowTexture_texel * 4,
                         SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr},
                        SELVAGE_ADDRESS_WRAP};
  const Kernels& kernels = kernel == SELVAGE_KERNEL_SCALAR
                               ? scalar_kernels(SELVAGE_FILTER_NEAREST)
                               : *vector_kernels(kernel, SELVAGE_FILTER_NEAREST);
  if (map.denominator_step() == 0) {
    const AffineLanes lanes(map, row.span);
    AffineField field = lanes.field(row.span);
    field.start.u_fx32 -= row.lag_fx32;
    field.start.v_fx32 -= row.lag_fx32;
    field.margin_fx32 += static_cast<uint32_t>(row.lag_fx32);
    kernels.draw_affine({one_span(row.span), field, kFarApart, ExactMap(map)}, surface);
  } else {
    const ProjectiveLanes lanes(map, row.span);
    EXPECT_LE(lanes.ratio(), 2 * kGentleRatio);
    kernels.draw_projective({one_span(row.span), lanes.field(row.span), kFarApart, ExactMap(map)},
                            surface);
  }
  return pixels;
}

TEST(NearTieDigits, AreEnoughForEveryRow) {
  for (uint64_t seed = 1; seed <= 30000; ++seed) {
    const NearTieRow row = any_near_tie_row(seed);
    const std::vector<uint32_t> scalar = drawn_near_ties(row, SELVAGE_KERNEL_SCALAR);
    for (const selvage_kernel kernel : usable_kernels()) {
      ASSERT_EQ(drawn_near_ties(row, kernel), scalar) << "kernel " << kernel << ", seed " << seed;
    }
  }
}

// Triangles whose denominators fall, or rise, from about 2^78 to 2^72 along each row.
[[nodiscard]] spec::Case far_apart(uint64_t seed) {
  spec::Random random(seed);
  spec::Case c;
  c.target_width_px = 2000;
  c.target_height_px = 12;
  c.texture_width_texel = c.texture_height_texel = kRowTexture_texel;
  c.address = SELVAGE_ADDRESS_WRAP;
  const bool falls = random.percent(50);
  const int32_t q_left = falls ? SELVAGE_Q_MAX : SELVAGE_Q_MAX / 64;
  const int32_t q_right = falls ? SELVAGE_Q_MAX / 64 : SELVAGE_Q_MAX;
  const int32_t third_px = random.percent(50) ? 2000 : 0;
  for (const auto& [x_px, y_px] :
       {std::pair(0, 0), {2000, 0}, {third_px, random.in(1000, 30000)}}) {
    c.vertices.push_back({x_px * 256, y_px * 256, random.in(-50 * 65536, 50 * 65536),
                          random.in(-50 * 65536, 50 * 65536), x_px == 0 ? q_left : q_right});
  }
  return c;
}

// Seed 821 has a row with one near-tie at its left end and one near the right.
TEST(NearTieDigits, AreEnoughForPlanes) {
  for (uint64_t seed = 781; seed <= 880; ++seed) {
    const spec::Case c = far_apart(seed);
    const spec::Canvas scalar = drawing_of(c, SELVAGE_KERNEL_SCALAR);
    for (const selvage_kernel kernel : usable_kernels()) {
      ASSERT_TRUE(drawing_of(c, kernel) == scalar) << "kernel " << kernel << ", seed " << seed;
    }
  }
}

}  // namespace
}  // namespace selvage::mapper
