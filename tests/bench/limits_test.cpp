// The limits write what they say, and load what they say.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "reports/bench/needed_lines.h"
#include "reports/bench/outlines.h"
#include "reports/bench/runs.h"
#include "reports/bench/spans.h"
#include "support.h"

namespace selvage::reports::test {
namespace {

constexpr uint32_t kFilled = 0x12345678, kBefore = 0xEEEEEEEE;

TEST(Fills, WriteTheirRunsAndNothingElse) {
  constexpr int32_t kMost_px = 70, kOffsets = 17;
  EXPECT_GE(fills_here().size(), 2u);
  for (const Fill& way : fills_here()) {
    for (int32_t count_px = 1; count_px <= kMost_px; ++count_px) {
      for (int32_t offset_px = 0; offset_px < kOffsets; ++offset_px) {
        std::vector<uint32_t> pixels(kMost_px + 2 * kOffsets, kBefore), wanted = pixels;
        std::fill_n(wanted.begin() + offset_px, count_px, kFilled);
        const PixelRun run{pixels.data() + offset_px, count_px};
        way.fill(std::span(&run, 1), kFilled);
        ASSERT_EQ(pixels, wanted) << way.name << ", " << count_px << " px from " << offset_px;
      }
    }
  }
}

TEST(Fills, AreChosenFromThoseOfThisMachine) {
  std::vector<uint32_t> pixels(64, kBefore);
  const std::vector<PixelRun> runs{{pixels.data(), 3}, {pixels.data() + 8, 40}};
  const std::string chosen = fastest_fill(runs).name;
  EXPECT_TRUE(std::ranges::any_of(fills_here(), [&](const Fill& f) { return f.name == chosen; }));
  EXPECT_EQ(std::ranges::count(pixels, kBefore), 64 - 43);
}

[[nodiscard]] uintptr_t line_of(const Texture& texture, uint32_t texel) {
  return reinterpret_cast<uintptr_t>(&texture.texels[texel]) / kLineBytes;
}

// Two squares that share texels, each minified.
[[nodiscard]] Workload two_squares() {
  Workload load = small_workload({});
  load.target_side_px = 64;
  load.texture_side_texel = 128;
  load.polygons = {turned_square(20.3, 20.6, 25, 128), turned_square(44.1, 40.7, 30, 128)};
  return load;
}

// The texels of each span, from the model, polygon by polygon.
[[nodiscard]] std::vector<std::vector<uint32_t>> modelled_spans(const Workload& load,
                                                                const Texture& texture) {
  std::vector<std::vector<uint32_t>> spans;
  for (const auto& polygon : load.polygons) {
    Workload one = load;
    one.polygons = {polygon};
    const ModelRows model =
        model_rows(one, sample_rows(one.target_side_px, one.target_side_px, 1), [] {});
    for (const auto& row : model.pixels) {
      std::vector<uint32_t> texels;
      for (const ModelPixel& pixel : row) {
        if (pixel.colour == kUntouched) continue;
        texels.push_back(static_cast<uint32_t>(row_of(pixel.colour) * texture.pitch_texel +
                                               column_of(pixel.colour)));
      }
      if (!texels.empty()) spans.push_back(std::move(texels));
    }
  }
  return spans;
}

TEST(NeededLines, AreThoseOfTheModelInItsOrder) {
  const Workload load = two_squares();
  const Texture texture(load.texture_side_texel);
  const NeededLines needed = needed_lines(load, texture);
  std::set<uintptr_t> lines;
  NeededLines wanted;
  for (const auto& span : modelled_spans(load, texture)) {
    for (const uint32_t texel : span) {
      if (lines.insert(line_of(texture, texel)).second) wanted.texels.push_back(texel);
    }
    wanted.end.push_back(wanted.texels.size());
  }
  EXPECT_EQ(needed.texels, wanted.texels);
  EXPECT_EQ(needed.end, wanted.end);
  Target target(load.target_side_px, load.target_side_px);
  EXPECT_EQ(needed.end.size(), runs_of(load, target).size());
  EXPECT_GT(lines.size(), 100u);
  EXPECT_LT(lines.size(), texture.texels.size() / 16);
}

TEST(Touch, CoversWhatTheModelCoversAndIsTimed) {
  const Plan plan = plan_of(two_squares(), {subject_touch(), subject_fill()});
  const auto results = measure(plan, quick_settings(), ignore_progress);
  for (const Cell& cell : results.at(0).cells) {
    EXPECT_EQ(cell.errors->total(), 0u);
    EXPECT_GT(cell.errors->covered_px, 500u);
    EXPECT_GT(cell.ns_per_px.median, 0);
  }
}

TEST(Touch, IsOfTexelsAsTheyAre) {
  Workload load = two_squares();
  load.filter = kBilinear;
  const Plan plan = plan_of(load, {subject_touch()});
  const auto results = measure(plan, quick_settings(), ignore_progress);
  EXPECT_EQ(results.at(0).cells.at(0).refusal, "it is not drawn bilinearly here");
}

}  // namespace
}  // namespace selvage::reports::test
