// The padding behind a target's rows: it is given to each subject as it was asked for, nobody draws
// there, and who does is found out.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "support.h"

namespace selvage::reports::test {
namespace {

constexpr int32_t kPaddings_px[] = {0, 1, kPadding_px, 100};

TEST(Padding, KeepsThePitchFromPowersOfTwo) {
  for (const int32_t side_px : {512, 1024, 2048}) {
    Target target(side_px, 2);
    EXPECT_FALSE(std::has_single_bit(static_cast<size_t>(target.image().pitch))) << side_px;
    EXPECT_EQ(target.image().pitch, side_px * 4 + 64);
    EXPECT_EQ(Target(side_px, 2, 0).image().pitch, side_px * 4);
  }
}

TEST(Padding, IsBehindEachRow) {
  for (const int32_t padding_px : kPaddings_px) {
    Target target(5, 3, padding_px);
    const selvage_image image = target.image();
    EXPECT_EQ(image.width, 5);
    EXPECT_EQ(image.pitch, (5 + padding_px) * 4);
    for (int32_t y = 0; y < 3; ++y)
      EXPECT_EQ(static_cast<void*>(target.row(y)),
                static_cast<char*>(image.pixels) + y * image.pitch);
    EXPECT_EQ(target.row(2) + 5 + padding_px, target.pixels.data() + target.pixels.size());
  }
}

[[nodiscard]] std::vector<ItemResult> measured(const Plan& plan, int32_t padding_px) {
  BenchSettings settings = quick_settings();
  settings.padding_px = padding_px;
  return measure(plan, settings, ignore_progress);
}

TEST(Padding, IsThatOfTheTargetsThatSubjectsAreGiven) {
  ptrdiff_t pitch = 0;
  Subject subject = box_subject("b", 0, 0);
  subject.prepare = [&pitch, draw = subject.prepare](const Workload& load, const Texture& texture,
                                                     Target& target) {
    pitch = target.image().pitch;
    return draw(load, texture, target);
  };
  const Plan plan = plan_of(small_workload({rectangle(2, 3, 10, 12)}), {subject});
  for (const int32_t padding_px : kPaddings_px) {
    (void)measured(plan, padding_px);
    EXPECT_EQ(pitch, (32 + padding_px) * 4);
  }
  (void)measure(plan, quick_settings(), ignore_progress);
  EXPECT_EQ(pitch, (32 + kPadding_px) * 4) << "by default";
}

// Covers the target and more on all sides, with texels that are all in the texture.
[[nodiscard]] Workload overhanging(bool perspective) {
  std::vector<selvage_vertex> triangle;
  for (const auto& [x, y] : {std::pair(-10, -9), std::pair(100, -9), std::pair(-10, 100)})
    triangle.push_back({x * 256, y * 256, (x + 14) * 32768, (y + 14) * 32768, 1});
  if (perspective) triangle[1].q = 2;
  Workload load = small_workload({triangle});
  load.perspective = perspective;
  return load;
}

[[nodiscard]] std::vector<Subject> all_subjects() {
  const Plan plan = make_plan(1, {.curves = false, .kernels = true},
                              [](std::string_view, std::string_view) { return true; });
  std::vector<Subject> all = plan.subjects;
  std::ranges::copy(subjects_in_layouts(), std::back_inserter(all));
  return all;
}

void expect_same_pixels(const Target& padded, const Target& plain) {
  for (int32_t y = 0; y < plain.height_px; ++y) {
    const uint32_t* row = padded.row(y);
    EXPECT_TRUE(std::equal(row, row + plain.width_px, plain.row(y))) << "row " << y;
    EXPECT_TRUE(std::all_of(row + padded.width_px, row + padded.pitch_px,
                            [](uint32_t pixel) { return pixel == kUntouched; }))
        << "behind row " << y;
  }
}

TEST(Padding, IsDrawnByNoSubjectAndChangesNoPixel) {
  size_t judged = 0;
  for (const bool perspective : {false, true}) {
    const Workload load = overhanging(perspective);
    const Texture texture(load.texture_side_texel);
    for (const Subject& subject : all_subjects()) {
      if (!subject.judged || !subject.refusal(load).empty()) continue;
      SCOPED_TRACE(subject.id + (perspective ? " in perspective" : ""));
      ++judged;
      Target plain(32, 32, 0);
      subject.prepare(load, texture, plain)();
      EXPECT_EQ(std::ranges::count(plain.pixels, kUntouched), 0);
      for (const int32_t padding_px : kPaddings_px) {
        Target padded(32, 32, padding_px);
        subject.prepare(load, texture, padded)();
        expect_same_pixels(padded, plain);
      }
    }
  }
  EXPECT_GT(judged, 20U);
}

// Right, but for a pixel behind one row that is not sampled.
[[nodiscard]] Subject careless_subject(int32_t behind_px) {
  Subject subject = box_subject("careless", 0, 0);
  subject.prepare = [behind_px, draw = subject.prepare](const Workload& load,
                                                        const Texture& texture,
                                                        Target& target) -> std::function<void()> {
    return [behind_px, &target, draw = draw(load, texture, target)] {
      draw();
      const std::vector<int32_t> sampled = sample_rows(32, 4, BenchSettings().seed);
      int32_t y = 0;
      while (std::ranges::count(sampled, y) > 0) ++y;
      target.row(y)[32 + behind_px] = 0;
    };
  };
  return subject;
}

TEST(Padding, IsNeverDrawnUnnoticed) {
  for (const int32_t behind_px : {0, kPadding_px - 1}) {
    Subject careless = careless_subject(behind_px);
    BenchSettings settings = quick_settings();
    settings.rows = 4;
    const Plan plan = plan_of(small_workload({rectangle(2, 3, 10, 12)}), {careless});
    const auto results = measure(plan, settings, ignore_progress);
    const ErrorCount& errors = *results.at(0).cells.at(0).errors;
    EXPECT_EQ(errors.judged_px, 4u * 32u);
    EXPECT_EQ(errors.extra_in_padding_px, 1u);
    EXPECT_EQ(errors.extra_px, 1u);
    EXPECT_EQ(errors.total(), 1u);
  }
}

TEST(Padding, StopsAReferenceThatDrawsThere) {
  for (const double tolerance_texel : {0.0, 1.0}) {
    Subject careless = careless_subject(0);
    careless.reference = true;
    careless.tolerance_texel = tolerance_texel;
    BenchSettings settings = quick_settings();
    settings.rows = 4;
    const Plan plan = plan_of(small_workload({rectangle(2, 3, 10, 12)}), {careless});
    try {
      (void)measure(plan, settings, ignore_progress);
      FAIL() << "a reference that draws in the padding was timed";
    } catch (const WrongAnswer& error) {
      EXPECT_NE(std::string(error.what()).find("1 extra, 1 of these in the padding of rows, 0 "),
                std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace selvage::reports::test
