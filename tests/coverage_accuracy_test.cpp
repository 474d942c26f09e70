// Mappers that claim that their coverage is rounded.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

#include "spec/canvas.h"
#include "spec/fan.h"
#include "spec/law_tools.h"
#include "spec/outline_distance.h"
#include "spec/promise.h"
#include "spec/row_choice.h"
#include "spec/verify.h"
#include "tests/expect_to_hold.h"
#include "tests/rounded_coverage.h"

namespace selvage::spec {
namespace {

[[nodiscard]] bool breaks(std::string_view law, const Subject& subject) {
  return verify(*find_law(law), subject, 1, 600).violation.has_value();
}

// To the last unit.
TEST(CoverageAccuracyAtLength, IsKeptByOneThatIsOffBySoMuch) {
  for (const auto& [dx_fx8, dy_fx8] : {std::pair{1, 0}, {-1, 1}, {37, -20}, {-256, 256}}) {
    const int32_t most_fx8 = std::max(std::abs(dx_fx8), std::abs(dy_fx8));
    expect_to_hold(claiming_px(moving(dx_fx8, dy_fx8), most_fx8 * kFx16OfFx8), 150);
  }
}

TEST(CoverageAccuracyAtLength, IsKeptByOneThatIsOffAtRandomWithinIt) {
  for (const int32_t most_fx8 : {1, 40, 256}) {
    expect_to_hold(claiming_px(moving_at_random(most_fx8), most_fx8 * kFx16OfFx8), 150);
  }
}

// Where a tile has hardly an area it may turn over: it is drawn, and cannot be subtracted.
TEST(CoverageAccuracyAtLength, IsKeptByOneThatSnapsVertices) {
  for (const int32_t step_fx8 : {16, 128}) {
    const Subject subject = claiming_px(snapping(step_fx8), step_fx8 / 2 * kFx16OfFx8);
    expect_to_hold(subject, 150);
    for (const char* law : {"PART", "PINWHEEL"}) {
      const LawVerdict verdict = verify(*find_law(law), subject, 1, 1500);
      EXPECT_FALSE(verdict.violation) << explain(*verdict.violation);
      EXPECT_GT(verdict.judged_px, 1000u) << law;
    }
  }
}

TEST(CoverageAccuracy, LeavesNoThinTriangleItsWinding) {
  const auto thin = [](int32_t height_fx8, int32_t accuracy_fx16) {
    const Vertices triangle = {{0, 0, 0, 0, 1}, {4096, 0, 0, 0, 1}, {2048, height_fx8, 0, 0, 1}};
    return may_turn_over(triangle, accuracy_fx16);
  };
  EXPECT_FALSE(thin(0, 0)) << "exact coverage turns nothing";
  EXPECT_TRUE(thin(32, 16 * kFx16OfFx8));
  EXPECT_TRUE(thin(-32, 16 * kFx16OfFx8));
  EXPECT_FALSE(thin(33, 16 * kFx16OfFx8));
}

// It tells NONE of rows that it leaves empty, and a method of those where all it draws is beside.
TEST(CoverageAccuracy, IsKeptByOneThatTellsWhatItDrawsBy) {
  Subject subject = claiming_px(snapping(64), 32 * kFx16OfFx8);
  subject.choose = [snapped = snapping(64)](
                       const selvage_image* target, const selvage_rect* clip,
                       const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                       const selvage_options* options, selvage_choice* choice) {
    selvage_rect row = clip != nullptr ? *clip : selvage_rect{0, 0, target->width, target->height};
    const int32_t top = std::max(row.top, 0), bottom = std::min(row.bottom, target->height);
    std::vector<uint8_t> pixels(static_cast<size_t>(target->width) *
                                static_cast<size_t>(target->height));
    const selvage_image mask{pixels.data(), target->width, target->height, target->width,
                             SELVAGE_INDEX8};
    const uint8_t one = 1;
    const selvage_texture ones{&one, 1, 1, 1, SELVAGE_INDEX8, SELVAGE_LAYOUT_ROWS, nullptr};
    const selvage_options plain{};
    *choice = {SELVAGE_METHOD_NONE, 0, 0};
    for (row.top = top; row.top < bottom; ++row.top) {
      row.bottom = row.top + 1;
      std::ranges::fill(pixels, uint8_t{0});
      (void)snapped.draw(&mask, &row, vertices, count, &ones, &plain);
      if (std::ranges::count(pixels, 1) == 0) continue;
      selvage_choice told{};
      const selvage_status status =
          selvage_choose(target, &row, vertices, count, texture, options, &told);
      if (status != SELVAGE_OK) return status;
      const bool is_filter = options->filter != SELVAGE_FILTER_NEAREST;
      if (told.method == SELVAGE_METHOD_NONE) {
        told.method = is_filter ? SELVAGE_METHOD_FILTER : SELVAGE_METHOD_EXACT_PERSPECTIVE;
      }
      *choice = together(*choice, told);
    }
    return selvage_status{SELVAGE_OK};
  };
  const LawVerdict verdict = verify(*find_law("TOLERANCE"), subject, 1, 300);
  EXPECT_FALSE(verdict.violation) << explain(*verdict.violation);
  subject.claims.coverage_accuracy_fx16 = 1;
  EXPECT_TRUE(breaks("TOLERANCE", subject));
}

TEST(CoverageAccuracy, IsToldHowMuchOfItIsNeeded) {
  const auto margin = [](int32_t claimed_fx8) {
    const Subject subject = claiming_px(moving(64, -64), claimed_fx8 * kFx16OfFx8);
    return verify(*find_law("COV"), subject, 1, 600).margin;
  };
  ASSERT_TRUE(margin(128));
  EXPECT_LE(margin(128)->share(), 0.5);
  EXPECT_GT(margin(128)->share(), 0.4);
  EXPECT_EQ(margin(128)->bound, 0.5);
  EXPECT_FALSE(verify(*find_law("COV"), claiming_px(built_in(), 256), 1, 100).margin) << "0 wrong";
}

TEST(CoverageAccuracy, IsNotKeptByOneThatIsOffByMore) {
  for (const int32_t off_fx8 : {16, 100}) {
    const int32_t claimed_fx16 = off_fx8 * kFx16OfFx8 / 2;
    for (const char* law : {"COV", "IDENTITY", "TOLERANCE", "SAME"}) {
      EXPECT_TRUE(breaks(law, claiming_px(moving(off_fx8, 0), claimed_fx16))) << law;
      EXPECT_TRUE(breaks(law, claiming_px(moving(0, -off_fx8), claimed_fx16))) << law;
    }
    const Subject at_random = claiming_px(moving_at_random(2 * off_fx8), claimed_fx16);
    for (const char* law : {"COV", "CLIP", "SAME"}) EXPECT_TRUE(breaks(law, at_random)) << law;
  }
}

// The left edge passes the first centre, 15/256 px away.
TEST(CoverageAccuracy, IsNotKeptByOneThatIsOffByAUnitMore) {
  Case c;
  c.target_width_px = c.target_height_px = 4;
  c.vertices = {{113, 0, 0, 0, 1}, {1024, 0, 65536, 0, 1}, {113, 2048, 0, 65536, 1}};
  const auto is_broken_by = [&](const Subject& subject) {
    return find_law("COV")->check(subject, c).violation.has_value();
  };
  EXPECT_TRUE(is_broken_by(moving(16, 0)));
  EXPECT_TRUE(is_broken_by(claiming_px(moving(16, 0), 15 * kFx16OfFx8 - 1)));
  EXPECT_FALSE(is_broken_by(claiming_px(moving(16, 0), 15 * kFx16OfFx8)));
  EXPECT_TRUE(breaks("COV", moving(1, 0)));
  EXPECT_TRUE(draws_exactly(Capabilities{}));
}

// Polygons that do not meet have a gap between them or draw pixels twice, however little.
TEST(CoverageAccuracy, LetsSharedEdgesBeExact) {
  const Subject by_outline = covering_moved([](const OutlineCall& drawing) {
    const selvage_vertex& last = drawing.vertices.back();
    return Point{((last.x ^ last.y) & 1) * 64, 0};
  });
  for (const char* law : {"PART", "PINWHEEL", "SPLIT"}) {
    EXPECT_TRUE(breaks(law, claiming_px(by_outline, SELVAGE_SUBTEXELS / 4))) << law;
  }
  const Subject by_texture = covering_moved([](const OutlineCall& drawing) {
    const auto side = static_cast<uint32_t>(drawing.texture.width);
    return Point{(side & (side - 1)) == 0 ? 64 : 0, 0};
  });
  EXPECT_TRUE(breaks("PART", claiming_px(by_texture, SELVAGE_SUBTEXELS / 4)));
}

// A texel beside the outline is any, one within is not; and nothing beyond the clip is drawn.
TEST(CoverageAccuracy, LeavesTexelsAndClipsExact) {
  Subject shifted = claiming_px(built_in(), SELVAGE_SUBTEXELS);
  shifted.draw = [](const selvage_image* target, const selvage_rect* clip,
                    const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                    const selvage_options* options) {
    std::vector<selvage_vertex> moved(vertices, vertices + count);
    for (selvage_vertex& v : moved) v.u += v.u < 0 ? SELVAGE_SUBTEXELS : -SELVAGE_SUBTEXELS;
    return selvage_draw(target, clip, moved.data(), count, texture, options);
  };
  EXPECT_TRUE(breaks("MAP", shifted));
  EXPECT_TRUE(breaks("GAMUT", shifted));
  // Nor may it show what no texel holds.
  Subject spoiling = claiming_px(moving(64, 0), SELVAGE_SUBTEXELS / 4);
  spoiling.draw = [draw = spoiling.draw](const selvage_image* target, const selvage_rect* clip,
                                         const selvage_vertex* vertices, size_t count,
                                         const selvage_texture* texture,
                                         const selvage_options* options) {
    const selvage_status status = draw(target, clip, vertices, count, texture, options);
    const Vertices right(vertices, vertices + count);
    const auto due = mask_of(*target, clip, right);
    const auto drawn = mask_of(*target, clip, moved_by(right, {64, 0}));
    for (size_t i = 0; i < due.size(); ++i) {
      const auto width = static_cast<size_t>(target->width);
      const ptrdiff_t row = static_cast<ptrdiff_t>(i / width) * target->pitch;
      const auto bytes = static_cast<size_t>(bytes_per_pixel(target->format));
      char* const pixel = static_cast<char*>(target->pixels) + row + i % width * bytes;
      if (drawn[i] != 0 && due[i] == 0) std::memset(pixel, 0x77, bytes);
    }
    return status;
  };
  EXPECT_TRUE(breaks("GAMUT", spoiling));
  Subject unclipped = claiming_px(built_in(), SELVAGE_SUBTEXELS);
  unclipped.draw = [](const selvage_image* target, const selvage_rect* clip,
                      const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                      const selvage_options* options) {
    selvage_rect wider = clip != nullptr ? *clip : selvage_rect{};
    wider.right += wider.right < 1000 ? 1 : 0;
    return selvage_draw(target, clip != nullptr ? &wider : nullptr, vertices, count, texture,
                        options);
  };
  for (const char* law : {"COV", "CLIP", "MEM"}) EXPECT_TRUE(breaks(law, unclipped)) << law;
}

// Near the outline, too: there the clip alone says that nothing is drawn.
TEST(CoverageAccuracy, LeavesNoDoubtBeyondTheClip) {
  constexpr int32_t kNear_fx16 = SELVAGE_SUBTEXELS / 2;
  Subject subject = claiming_px(built_in(), kNear_fx16);
  subject.draw = [](const selvage_image* target, const selvage_rect* clip,
                    const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                    const selvage_options* options) {
    const selvage_status status = selvage_draw(target, clip, vertices, count, texture, options);
    if (status != SELVAGE_OK || clip == nullptr) return status;
    const auto bytes = static_cast<size_t>(bytes_per_pixel(target->format));
    Case clipped;
    clipped.has_clip = true;
    clipped.clip = *clip;
    for (int32_t y = 0; y < target->height; ++y) {
      char* const row = static_cast<char*>(target->pixels) + y * target->pitch;
      for (int32_t x = 0; x < target->width; ++x) {
        if (is_visible(clipped, {x, y}) ||
            !is_near_outline(pixel_centre(x, y), {vertices, count}, kNear_fx16)) {
          continue;
        }
        std::memcpy(row + static_cast<size_t>(x) * bytes, texture->texels, bytes);
      }
    }
    return status;
  };
  for (const char* law : {"COV", "CLIP", "MEM"}) EXPECT_TRUE(breaks(law, subject)) << law;
}

TEST(CoverageAccuracy, IsToldOfTheLawsThatItTakesAPartOf) {
  Capabilities claims;
  claims.coverage_accuracy_fx16 = 256;
  const auto note = [&](const char* law) {
    return promise(SELVAGE_PROFILE_EXACT, claims, law).note;
  };
  EXPECT_EQ(note("COV"), "within the accuracy of its coverage");
  EXPECT_EQ(note("MAP"), "");
  EXPECT_EQ(note("CLIP"), "but for pixels within its accuracy of the outline");
  claims.accuracy_fx16 = 256;
  EXPECT_EQ(note("MAP"), "within its accuracy");
  EXPECT_EQ(note("COV"), "within the accuracy of its coverage");
  EXPECT_EQ(note("CLIP"),
            "the coverage, but for pixels within its accuracy of the outline; texels are within "
            "theirs (MAP)");
}

}  // namespace
}  // namespace selvage::spec
