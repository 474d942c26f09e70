// That each peer is asked for the right picture: what it draws of the work items lies where it
// must, up to its own rounding.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "reports/bench/error_count.h"
#include "reports/bench/subject.h"

namespace selvage::reports {
namespace {

ErrorCount judge(const Subject& subject, const Workload& load, const ModelRows& model) {
  const Texture texture(load.texture_side_texel, texels_for(load.filter));
  Target target(load.target_side_px, load.target_side_px);
  subject.prepare(load, texture, target)();
  return count_errors(model, target, subject.textures, load.filter, subject.carried_bits);
}

// Weights that are rounded to 1/16 move a sample by up to 1/32 texel in u and in v, on levels that
// are up to 254 apart.
constexpr int32_t kCoarsest_level = 16;

// The coarsest of them, SDL, truncates vertices to whole pixels and whole texels.
TEST(Peers, DrawTheWorkItemsWhereTheyAre) {
  const Peers all = peers();
  for (const std::string& absent : all.absent) std::cout << "not tested: " << absent << "\n";
  for (const Workload& load : workloads(1)) {
    const auto model = model_rows(load, sample_rows(load.target_side_px, 8, 1), [] {});
    for (const Subject& subject : all.subjects) {
      if (!subject.refusal(load).empty() || (load.filter == kBilinear && !subject.bilinear) ||
          (load.filter == kArea && !subject.area)) {
        continue;
      }
      SCOPED_TRACE(load.id + " " + subject.id);
      const ErrorCount errors = judge(subject, load, model);
      ASSERT_GT(errors.covered_px, 0u);
      EXPECT_EQ(errors.extra_in_padding_px, 0u);
      // Around small squares a pixel along each side is much.
      const double share = load.id == "W9" ? 4.0 / 28 : 0.01;
      EXPECT_LE(static_cast<double>(errors.missing_px + errors.extra_px),
                share * static_cast<double>(errors.covered_px));
      EXPECT_LE(errors.mean_texel(), 1.5);
      EXPECT_LE(errors.largest_texel, 4);
      EXPECT_LE(errors.mean_level(), 4);
      EXPECT_LE(errors.largest_level, kCoarsest_level);
    }
  }
}

// Each drawing keeps to its own target, texture and workload when several are ready to be drawn.
TEST(Peers, DrawingsReadyTogetherDoNotMix) {
  const std::vector<Workload> loads = workloads(1);
  const Workload& first = loads.front();
  const Workload& second = *std::ranges::find(loads, "W6", &Workload::id);
  const Texture first_texture(first.texture_side_texel), second_texture(second.texture_side_texel);
  for (const Subject& subject : peers().subjects) {
    if (!subject.refusal(first).empty() || !subject.refusal(second).empty()) continue;
    SCOPED_TRACE(subject.id);
    Target alone(first.target_side_px, first.target_side_px), together = alone;
    Target other(second.target_side_px / 2, second.target_side_px / 2);
    subject.prepare(first, first_texture, alone)();
    const auto draw_first = subject.prepare(first, first_texture, together);
    const auto draw_second = subject.prepare(second, second_texture, other);
    draw_second();
    draw_first();
    EXPECT_EQ(alone.pixels, together.pixels);
    EXPECT_TRUE(std::any_of(other.pixels.begin(), other.pixels.end(),
                            [](uint32_t pixel) { return pixel != kUntouched; }));
  }
}

}  // namespace
}  // namespace selvage::reports
