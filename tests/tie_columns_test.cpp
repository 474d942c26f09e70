// Rows of which most pixels are near-ties, drawn column by column: narrow ones of planes and any of
// none, of one slab or several to a block of rows, some without pixels, where edges touch too;
// within the texture, at its edges and beyond them; in perspective up to the greatest denominators.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "spec/random.h"
#include "spec/vertex_units.h"
#include "tests/any_surfaces.h"
#include "tests/kernel_support.h"

namespace selvage::mapper {
namespace {

using spec::kPixel_fx8;
using spec::kTexel_fx16;

[[nodiscard]] spec::Case target_of_rows(spec::Random& random) {
  spec::Case c = any_surfaces(random);
  c.target_width_px = random.percent(70)   ? random.in(1, 40)
                      : random.percent(70) ? random.in(40, 90)
                                           : random.in(90, 280);
  c.target_height_px = random.in(2, 180);
  c.texture_width_texel = random.pick({3, 17, 64, 256});
  c.texture_height_texel = random.pick({2, 17, 64, 256});
  c.padding_px = random.in(0, 3);
  return c;
}

// Whole at the centre of the target's first pixel; slopes are whole numbers of 1 / px.
struct TieMap {
  int32_t s, t, px;
  int32_t s_right, s_down, t_right, t_down;
};

[[nodiscard]] TieMap tie_map(spec::Random& random, const spec::Case& c) {
  const auto slope = [&] { return random.pick({0, 1, 1, -1, 2, -3}); };
  return {random.pick({0, 1, c.texture_width_texel / 2, c.texture_width_texel, -90}),
          random.pick({0, 1, c.texture_height_texel / 2, c.texture_height_texel, -90}),
          random.pick({1, 1, 2, 3, 6, 8, 16}),
          slope(),
          slope(),
          slope(),
          slope()};
}

// What corners are apart in q: nothing, or whatever makes denominators long.
struct Depth {
  int32_t across, down;

  [[nodiscard]] int32_t q_at(bool is_right, bool is_below) const {
    return SELVAGE_Q_MAX - (is_right ? across : 0) - (is_below ? down : 0);
  }
};

// Two chains of vertices, maybe with one between their ends, from above the target's rows or from
// some of them to below; texels lowered by a unit or not at all, and so maybe in no plane.
void set_chains(spec::Random& random, const TieMap& map, const Depth& depth, spec::Case* c) {
  const int32_t width_px = c->target_width_px, height_px = c->target_height_px;
  const int32_t tall_px = random.pick({0, 0, 0, 3, 200, 20000});
  const int32_t lowered = random.pick({0, 1, 1, 2});
  const int32_t slant_px = random.percent(50) ? random.in(0, width_px + 1) : 0;
  const auto add = [&](int32_t x_px, int32_t y_px, int32_t q) {
    const auto fx16 = [&](int32_t whole, int32_t right, int32_t down) {
      const int64_t steps = int64_t{right} * x_px + int64_t{down} * y_px;
      const int64_t at = whole * int64_t{kTexel_fx16} + steps * kTexel_fx16 / map.px;
      return static_cast<int32_t>(at % (int64_t{1} << 30)) - random.in(0, lowered + 1);
    };
    const int32_t half_px = kPixel_fx8 / 2;
    c->vertices.push_back({x_px * kPixel_fx8 + half_px, y_px * kPixel_fx8 + half_px,
                           fx16(map.s, map.s_right, map.s_down),
                           fx16(map.t, map.t_right, map.t_down), q});
  };
  const auto between = [&] { return random.percent(40); };
  const int32_t middle_px = height_px / 2;
  add(slant_px, -tall_px, depth.q_at(false, false));
  add(slant_px + width_px / 2, random.in(-tall_px, middle_px), depth.q_at(true, false));
  if (between()) add(width_px, middle_px, depth.q_at(true, false));
  add(width_px - slant_px / 3, height_px + tall_px, depth.q_at(true, true));
  add(random.in(-3, 4), random.in(middle_px, height_px + tall_px + 1), depth.q_at(false, true));
  if (between()) add(-2, random.in(0, middle_px + 1), depth.q_at(false, false));
}

// A block of seeds.
class TieColumns : public testing::TestWithParam<uint64_t> {
 protected:
  // At least half of them must be polygons.
  static void expect_all_drawn_alike(uint64_t block, const std::vector<int32_t>& differences) {
    constexpr uint64_t kSeeds = 1200;
    uint64_t drawn = 0;
    for (uint64_t seed = block * kSeeds + 1; seed <= (block + 1) * kSeeds; ++seed) {
      spec::Random random(seed);
      spec::Case c = target_of_rows(random);
      const auto difference = [&] {
        return differences[static_cast<size_t>(
            random.in(0, static_cast<int32_t>(differences.size())))];
      };
      set_chains(random, tie_map(random, c), {difference(), difference()}, &c);
      ASSERT_NO_FATAL_FAILURE(expect_drawn_alike(c, seed));
      drawn += drawing_of(c, SELVAGE_KERNEL_SCALAR) == target_of(c) ? 0 : 1;
    }
    EXPECT_GT(drawn, kSeeds / 2);
  }
};

TEST_P(TieColumns, EveryKernelDrawsWhatTheScalarOneDraws) {
  expect_all_drawn_alike(GetParam(), {0});
}

TEST_P(TieColumns, EveryKernelDrawsWhatTheScalarOneDrawsInPerspective) {
  expect_all_drawn_alike(GetParam(), {0, 1, 1, 1 << 8, SELVAGE_Q_MAX / 3});
}

INSTANTIATE_TEST_SUITE_P(Block, TieColumns, testing::Range(uint64_t{0}, uint64_t{4}));

}  // namespace
}  // namespace selvage::mapper
