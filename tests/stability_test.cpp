// The measurement of the stability table, by scenes small enough to be counted by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "reports/stability/bound.h"
#include "reports/stability/measure.h"
#include "spec/law_tools.h"
#include "spec/vertex_units.h"

namespace selvage::stability {
namespace {

using spec::Case;
using spec::kPixel_fx8;
using spec::kTexel_fx16;
using spec::Rational;
using spec::Texel;

// Columns [1, 4) of a row of 6 pixels; u is 1/3, 1, 5/3 at their centres.
[[nodiscard]] Case thirds() {
  Case c;
  c.target_width_px = 6;
  c.target_height_px = 1;
  c.texture_width_texel = 4;
  c.texture_height_texel = 1;
  c.vertices = {{kPixel_fx8, 0, 0, 0, 1},
                {4 * kPixel_fx8, 0, 2 * kTexel_fx16, 0, 1},
                {4 * kPixel_fx8, kPixel_fx8, 2 * kTexel_fx16, kTexel_fx16, 1},
                {kPixel_fx8, kPixel_fx8, 0, kTexel_fx16, 1}};
  return c;
}

// Draws these columns' texels of row 0, whatever it is asked.
[[nodiscard]] Contender painter(std::vector<std::pair<int32_t, int32_t>> column_and_s,
                                Promise promise = Promise::kNothing) {
  const auto paint = [=](const selvage_image* target, const selvage_rect*, const selvage_vertex*,
                         size_t, const selvage_texture*, const selvage_options*) -> selvage_status {
    for (const auto& [x, s] : column_and_s) {
      static_cast<uint32_t*>(target->pixels)[x] = static_cast<uint32_t>(s);
    }
    return SELVAGE_OK;
  };
  return {"painter", "", promise, SELVAGE_PROFILE_EXACT, false, {"painter", paint}};
}

[[nodiscard]] Contender named(std::string_view name,
                              const spec::Subject& mapper = spec::built_in()) {
  const std::vector<Contender> all = contenders(mapper);
  return *std::find_if(all.begin(), all.end(), [&](const auto& c) { return c.name == name; });
}

TEST(Reference, IsTheExactModel) {
  const Reference model = reference(thirds());
  EXPECT_EQ(model.covered_px, 3u);
  const std::optional<Texel> expected[] = {{}, Texel{0, 0}, Texel{1, 0}, Texel{1, 0}, {}, {}};
  EXPECT_TRUE(std::equal(model.texels.begin(), model.texels.end(), std::begin(expected),
                         std::end(expected)));
}

TEST(Reference, KnowsTheClipAndNothingOfFormats) {
  Case c = thirds();
  c.format = SELVAGE_INDEX8;
  c.has_clip = true;
  c.clip = {-5, -5, 3, 9};
  const Reference model = reference(c);
  EXPECT_EQ(model.covered_px, 2u);
  EXPECT_FALSE(model.texels[3]);
  EXPECT_EQ(model.scene.format, SELVAGE_RGBA8888);
}

TEST(Reference, OfWhatIsNoOutlineCoversNothing) {
  Case c = thirds();
  c.vertices.resize(2);
  EXPECT_EQ(reference(c).covered_px, 0u);
  EXPECT_EQ(reference(c).texels.size(), 6u);
}

TEST(Errors, OfAHandPaintedRow) {
  // Column 0 is extra, 1 is right, 2 is off by two, 3 is missing.
  const Errors errors = errors_of(painter({{0, 0}, {1, 0}, {2, 3}}), reference(thirds()));
  EXPECT_EQ(errors.compared_px, 2u);
  EXPECT_EQ(errors.missing_px, 1u);
  EXPECT_EQ(errors.extra_px, 1u);
  EXPECT_EQ(errors.wrong_texels, 1u);
  EXPECT_EQ(errors.largest_texel, 2);
  EXPECT_DOUBLE_EQ(errors.wrong_share(), 0.5);
  EXPECT_DOUBLE_EQ(errors.mean_texel(), 1);
  EXPECT_FALSE(errors.part_of_bound);
  EXPECT_EQ(errors.memory_fault, "");
}

TEST(Errors, OfSixteenBitsByHand) {
  const Errors errors = errors_of(named("fixed1616"), reference(thirds()));
  EXPECT_EQ(errors.compared_px, 3u);
  EXPECT_EQ(errors.wrong_texels, 1u);
  EXPECT_EQ(errors.largest_texel, 1);
  EXPECT_DOUBLE_EQ(errors.mean_texel(), 1.0 / 3);
}

TEST(Errors, GoTheShorterWayRoundInWrapMode) {
  Case c = thirds();
  const Contender far_off = painter({{1, 3}, {2, 1}, {3, 1}});
  EXPECT_EQ(errors_of(far_off, reference(c)).largest_texel, 3);
  c.address = SELVAGE_ADDRESS_WRAP;
  EXPECT_EQ(errors_of(far_off, reference(c)).largest_texel, 1);
  EXPECT_EQ(texel_distance(0, 2, 4, SELVAGE_ADDRESS_WRAP), 2);
  EXPECT_EQ(texel_distance(3, 0, 4, SELVAGE_ADDRESS_WRAP), 1);
  EXPECT_EQ(texel_distance(3, 0, 4, SELVAGE_ADDRESS_CLAMP), 3);
}

TEST(Errors, ReportWhatNoTexelHolds) {
  const Errors errors = errors_of(painter({{1, 77}}), reference(thirds()));
  EXPECT_EQ(errors.memory_fault, "a pixel shows what no texel holds");
  EXPECT_FALSE(errors.keeps(Promise::kNothing));
}

TEST(Errors, OfNothingAreNone) {
  EXPECT_EQ(Errors{}.wrong_share(), 0);
  EXPECT_EQ(Errors{}.mean_texel(), 0);
  EXPECT_TRUE(Errors{}.flawless());
}

TEST(Errors, AddUp) {
  Errors sum;
  sum.add({.compared_px = 4, .missing_px = 1, .largest_texel = 3, .sum_texel = 5});
  sum.add({.compared_px = 6, .wrong_texels = 2, .largest_texel = 1, .part_of_bound = 0.5});
  sum.add({.largest_outline_px = 0.25});
  sum.add({.largest_outline_px = 0.125});
  sum.add({.extra_px = 7, .part_of_bound = 0.25, .refused_cases = 1, .memory_fault = "one"});
  sum.add({.memory_fault = "two"});
  EXPECT_EQ(sum.compared_px, 10u);
  EXPECT_EQ(sum.missing_px, 1u);
  EXPECT_EQ(sum.extra_px, 7u);
  EXPECT_EQ(sum.largest_texel, 3);
  EXPECT_DOUBLE_EQ(sum.mean_texel(), 0.5);
  EXPECT_EQ(sum.largest_outline_px, 0.25);
  EXPECT_EQ(sum.part_of_bound, 0.5);
  EXPECT_EQ(sum.refused_cases, 1u);
  EXPECT_EQ(sum.memory_fault, "one");
}

TEST(Errors, KeepAPromiseOrBreakIt) {
  const Errors within{.compared_px = 9, .wrong_texels = 3, .part_of_bound = 1.0};
  EXPECT_TRUE(within.keeps(Promise::kBound));
  EXPECT_TRUE(within.keeps(Promise::kNothing));
  EXPECT_FALSE(within.keeps(Promise::kExact));
  Errors beyond = within;
  beyond.part_of_bound = 1.0000001;
  EXPECT_FALSE(beyond.keeps(Promise::kBound));
  EXPECT_FALSE(Errors{.missing_px = 1}.keeps(Promise::kExact));
  EXPECT_FALSE(Errors{.extra_px = 1}.keeps(Promise::kExact));
  EXPECT_FALSE((Errors{.part_of_bound = 0, .refused_cases = 1}).keeps(Promise::kBound));
}

TEST(Errors, AreWorseByTheirLargestThenTheirNumber) {
  const Errors far{.wrong_texels = 1, .largest_texel = 5},
      many{.wrong_texels = 9, .largest_texel = 1};
  const Errors missing{.missing_px = 4};
  EXPECT_TRUE(is_worse(far, many, Promise::kNothing));
  EXPECT_FALSE(is_worse(many, far, Promise::kNothing));
  EXPECT_TRUE(is_worse(many, missing, Promise::kNothing));
  EXPECT_TRUE(is_worse(missing, Errors{}, Promise::kNothing));
  EXPECT_FALSE(is_worse(far, far, Promise::kNothing));
  const Errors broken{.part_of_bound = 2.0}, kept{.largest_texel = 9, .part_of_bound = 0.5};
  EXPECT_TRUE(is_worse(broken, kept, Promise::kBound));
}

// Of 8 texels; 3 is shown by [3, 4), its interval being [3 - r, 4 - r) with the rounding r.
[[nodiscard]] double part(const Rational& exact, int32_t drawn, const Rational& rounding = 0,
                          selvage_address address = SELVAGE_ADDRESS_CLAMP) {
  return part_of_bound({exact, Rational(1, 2), Rational(1, 4)}, drawn, 8, address, rounding);
}

TEST(PartOfBound, IsTheDistanceToTheTexelsIntervalOnItsSide) {
  EXPECT_EQ(part(Rational(7, 2), 3), 0);
  EXPECT_EQ(part(3, 3), 0);
  EXPECT_DOUBLE_EQ(part(Rational(23, 8), 3), 0.5);  // 1/8 below, of 1/4 above
  EXPECT_DOUBLE_EQ(part(Rational(17, 4), 3), 0.5);  // 1/4 beyond, of 1/2 below
  EXPECT_DOUBLE_EQ(part(Rational(5, 2), 3), 2);     // too far
  EXPECT_DOUBLE_EQ(part(5, 3), 2);
}

TEST(PartOfBound, TakesTheRoundingBeforeTheTexel) {
  const Rational half(1, 2);
  EXPECT_EQ(part(Rational(5, 2), 3, half), 0);
  EXPECT_DOUBLE_EQ(part(Rational(19, 8), 3, half), 0.5);
  EXPECT_DOUBLE_EQ(part(Rational(15, 4), 3, half), 0.5);
}

TEST(PartOfBound, KnowsWhatTheBorderShows) {
  EXPECT_EQ(part(-20, 0), 0);
  EXPECT_EQ(part(20, 7), 0);
  EXPECT_DOUBLE_EQ(part(Rational(5, 4), 0), 0.5);
  EXPECT_DOUBLE_EQ(part(Rational(55, 8), 7), 0.5);
  EXPECT_GT(part(-20, 1), 1);
}

TEST(PartOfBound, GoesTheNearerWayRoundInWrapMode) {
  const auto wrapped = [](const Rational& exact, int32_t drawn) {
    return part(exact, drawn, 0, SELVAGE_ADDRESS_WRAP);
  };
  EXPECT_EQ(wrapped(-5, 3), 0);
  EXPECT_EQ(wrapped(Rational(23, 2), 3), 0);
  EXPECT_DOUBLE_EQ(wrapped(Rational(63, 8), 0), 0.5);   // 8 is 1/8 above
  EXPECT_DOUBLE_EQ(wrapped(Rational(33, 4), 7), 0.5);   // 8 is 1/4 below
  EXPECT_DOUBLE_EQ(wrapped(Rational(-1, 8), 0), 0.5);   // 0 is 1/8 above
  EXPECT_DOUBLE_EQ(wrapped(Rational(-31, 4), 7), 0.5);  // -8 is 1/4 below
}

TEST(PartOfBound, IsInfiniteWhereThereIsNone) {
  const spec::Rational zero = 0;
  EXPECT_EQ(part_of_bound({4, zero, zero}, 3, 8, SELVAGE_ADDRESS_CLAMP, 0),
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(part_of_bound({3, zero, zero}, 3, 8, SELVAGE_ADDRESS_CLAMP, 0), 0);
}

TEST(Contenders, AreEightInTheOrderOfTheTable) {
  std::vector<std::string> names;
  for (const Contender& contender : contenders(spec::built_in())) {
    names.emplace_back(contender.name);
    EXPECT_EQ(contender.promise == Promise::kExact, contender.name == "exact");
    EXPECT_EQ(contender.promise == Promise::kBound, contender.profile != SELVAGE_PROFILE_EXACT);
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"abrash56", "abrash57", "dkit", "fixed1616", "float32-dda",
                                      "float32-plane", "float64-dda", "exact"}));
}

TEST(Contenders, OfAProfileDrawInItsWay) {
  const Case c = in_its_way(named("abrash57"), thirds());
  EXPECT_EQ(c.profile, SELVAGE_PROFILE_ABRASH57);
  EXPECT_EQ(in_its_way(named("float32-dda"), thirds()), thirds());
  EXPECT_EQ(in_its_way(named("exact"), thirds()), thirds());
}

// What a profile draws by a mapper that is a texel off is beyond its bound.
TEST(Errors, OfAMapperBeyondItsBoundAreSeen) {
  const spec::Subject off{
      "off",
      [](const selvage_image* target, const selvage_rect* clip, const selvage_vertex* vertices,
         size_t count, const selvage_texture* texture, const selvage_options* options) {
        std::vector<selvage_vertex> moved(vertices, vertices + count);
        for (selvage_vertex& vertex : moved) vertex.u += kTexel_fx16;
        return selvage_draw(target, clip, moved.data(), count, texture, options);
      }};
  Case c = thirds();
  c.texture_width_texel = 256;  // magnified, so that one texel is more than whole columns explain
  for (const char* profile : {"abrash56", "abrash57", "dkit"}) {
    const Errors good = errors_of(named(profile), reference(c));
    EXPECT_TRUE(good.keeps(Promise::kBound)) << profile << " " << *good.part_of_bound;
    const Errors bad = errors_of(named(profile, off), reference(c));
    EXPECT_FALSE(bad.keeps(Promise::kBound)) << profile << " " << *bad.part_of_bound;
  }
}

// Nor may it draw other pixels than its own profile covers: none at all would be within any bound.
TEST(Errors, OfAMapperThatCoversOtherPixelsAreSeen) {
  const spec::Subject blank{
      "blank",
      [](const selvage_image*, const selvage_rect*, const selvage_vertex*, size_t,
         const selvage_texture*, const selvage_options*) -> selvage_status { return SELVAGE_OK; }};
  for (const char* profile : {"abrash56", "abrash57", "dkit"}) {
    EXPECT_EQ(errors_of(named(profile), reference(thirds())).own_coverage_px, 0u);
    const Errors none = errors_of(named(profile, blank), reference(thirds()));
    EXPECT_GT(none.own_coverage_px, 0u);
    EXPECT_FALSE(none.keeps(Promise::kBound)) << profile;
  }
}

// The scenes of seeds 4, 5, 6 hold one, two and three wrong texels.
[[nodiscard]] Case scene_of_seed(uint64_t seed) {
  Case c = thirds();
  c.has_clip = true;
  c.clip = {0, 0, static_cast<int32_t>(seed) - 2, 1};
  return c;
}

TEST(Measure, AddsTheScenesUpAndNamesTheWorst) {
  const spec::HardFamily family{"narrow", "as clipped", scene_of_seed};
  const std::vector<Contender> painters{painter({}), painter({{1, 3}, {2, 3}, {3, 3}})};
  std::vector<uint64_t> progress;
  const FamilyRow row =
      measure(family, painters, 4, 3, [&](uint64_t done) { progress.push_back(done); });
  EXPECT_EQ(row.covered_px, 1u + 2 + 3);
  EXPECT_EQ(progress, (std::vector<uint64_t>{0, 1, 2}));
  ASSERT_EQ(row.cells.size(), 2u);
  EXPECT_EQ(row.cells[0].errors.missing_px, 6u);
  EXPECT_EQ(row.cells[0].worst->seed, 6u);
  EXPECT_EQ(row.cells[1].errors.compared_px, 6u);
  EXPECT_EQ(row.cells[1].errors.wrong_texels, 6u);
  EXPECT_EQ(row.cells[1].errors.extra_px, 3u);
  EXPECT_EQ(row.cells[1].worst->seed, 6u);
  EXPECT_EQ(row.cells[1].worst->errors.wrong_texels, 3u);
}

TEST(Measure, OfAllFamiliesKeepsEveryPromise) {
  const std::vector<Contender> all = contenders(spec::built_in());
  for (const spec::HardFamily& family : spec::hard_families()) {
    const FamilyRow row = measure(family, all, 1, 1);
    for (const Cell& cell : row.cells) {
      EXPECT_TRUE(cell.errors.keeps(cell.contender->promise))
          << family.name << ", " << cell.contender->name;
      if (cell.contender->promise == Promise::kExact) {
        EXPECT_FALSE(cell.worst);
        EXPECT_EQ(cell.errors.compared_px, row.covered_px);
      }
    }
  }
}

}  // namespace
}  // namespace selvage::stability
