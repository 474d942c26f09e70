// Mappers that claim that their coverage is rounded.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "spec/canvas.h"
#include "spec/law_tools.h"
#include "spec/promise.h"
#include "spec/verify.h"

namespace selvage::spec {
namespace {

// What a call is about that may move an outline.
struct Drawing {
  const selvage_rect* clip;
  const std::vector<selvage_vertex>& vertices;
  const selvage_texture& texture;
  const selvage_options& options;
};
using MoveOf = std::function<Point(const Drawing&)>;  // in 1/256 px

[[nodiscard]] std::vector<selvage_vertex> moved_by(std::vector<selvage_vertex> vertices, Point by) {
  const auto in_range = [](int64_t fx8) {
    return static_cast<int32_t>(std::clamp<int64_t>(fx8, SELVAGE_X_MIN, SELVAGE_X_END - 1));
  };
  for (selvage_vertex& v : vertices) {
    v.x = in_range(v.x + by.x);
    v.y = in_range(v.y + by.y);
  }
  return vertices;
}

// Which pixels of a target an outline covers.
[[nodiscard]] std::vector<uint8_t> mask_of(const selvage_image& target, const selvage_rect* clip,
                                           const std::vector<selvage_vertex>& vertices) {
  const auto width = static_cast<size_t>(target.width);
  std::vector<uint8_t> pixels(width * static_cast<size_t>(target.height), 0);
  const selvage_image image{pixels.data(), target.width, target.height, target.width,
                            SELVAGE_INDEX8};
  const uint8_t one = 1;
  const selvage_texture texture{&one, 1, 1, 1, SELVAGE_INDEX8, SELVAGE_LAYOUT_ROWS, nullptr};
  EXPECT_EQ(selvage_draw(&image, clip, vertices.data(), vertices.size(), &texture, nullptr),
            SELVAGE_OK);
  return pixels;
}

// The mapper that this program is linked with, its coverage that of an outline moved by
// move_of(...): its texels are exact, and the first of the texture beside the right outline.
[[nodiscard]] Subject covering(const MoveOf& move_of) {
  Subject subject = built_in();
  subject.draw = [=](const selvage_image* target, const selvage_rect* clip,
                     const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                     const selvage_options* options) {
    const std::vector<selvage_vertex> right(vertices, vertices + count);
    const auto wrong = moved_by(right, move_of({clip, right, *texture, *options}));
    std::vector<std::vector<char>> before;
    const auto bytes = static_cast<size_t>(bytes_per_pixel(target->format));
    const auto row_of = [&](int32_t y) {
      return static_cast<char*>(target->pixels) + y * target->pitch;
    };
    for (int32_t y = 0; y < target->height; ++y) {
      before.emplace_back(row_of(y), row_of(y) + bytes * static_cast<size_t>(target->width));
    }
    const selvage_status status = selvage_draw(target, clip, vertices, count, texture, options);
    if (status != SELVAGE_OK) return status;
    const auto due = mask_of(*target, clip, right), drawn = mask_of(*target, clip, wrong);
    for (size_t i = 0; i < due.size(); ++i) {
      const size_t y = i / static_cast<size_t>(target->width);
      const size_t at = i % static_cast<size_t>(target->width) * bytes;
      if (due[i] == drawn[i]) continue;
      const char* from = due[i] ? before[y].data() + at : static_cast<const char*>(texture->texels);
      std::memcpy(row_of(static_cast<int32_t>(y)) + at, from, bytes);
    }
    return status;
  };
  subject.draw_many = {};
  subject.choose = {};
  subject.claims.named_errors = false;  // all arguments are looked at
  subject.claims.concave = false;       // moved within the range that coordinates have
  return subject;
}

[[nodiscard]] Subject claiming_px(Subject subject, int32_t coverage_accuracy_fx16) {
  subject.claims.coverage_accuracy_fx16 = coverage_accuracy_fx16;
  return subject;
}

constexpr int32_t kFx16PerFx8 = SELVAGE_SUBTEXELS / SELVAGE_SUBPIXELS;

[[nodiscard]] Subject moving(int32_t dx_fx8, int32_t dy_fx8) {
  return covering([=](const Drawing&) { return Point{dx_fx8, dy_fx8}; });
}

// By something else under another clip, from another texture, by another kernel, as rounding is
// that depends on where it begins.
[[nodiscard]] Subject moving_at_random(int32_t most_fx8) {
  return covering([=](const Drawing& drawing) {
    uint32_t hash = 1;
    const auto add = [&](auto... values) {
      ((hash = (hash ^ static_cast<uint32_t>(values)) * 0x9E3779B1U, hash ^= hash >> 15), ...);
    };
    const auto [clip, vertices, texture, options] = drawing;
    if (clip != nullptr) add(clip->left, clip->top, clip->right, clip->bottom);
    add(texture.layout, texture.pitch, options.kernel);
    Choices choices(hash);
    const auto some = [&] { return int64_t{choices.pick(-most_fx8, most_fx8 + 1)}; };
    return Point{some(), some()};
  });
}

void expect_to_hold_all(const Subject& subject, uint64_t cases) {
  for (const Law& law : laws()) {
    if (promise(subject.profile, subject.claims, law.name).standing != Standing::kPromised) {
      continue;
    }
    const LawVerdict verdict = verify(law, subject, 1, cases);
    EXPECT_FALSE(verdict.violation) << explain(*verdict.violation);
    EXPECT_GT(verdict.judged_px, 0u) << law.name;
  }
}

[[nodiscard]] bool breaks(std::string_view law, const Subject& subject) {
  return verify(*find_law(law), subject, 1, 600).violation.has_value();
}

// To the last unit.
TEST(CoverageAccuracyAtLength, IsKeptByOneThatIsOffBySoMuch) {
  for (const auto& [dx_fx8, dy_fx8] : {std::pair{1, 0}, {-1, 1}, {37, -20}, {-256, 256}}) {
    const int32_t most_fx8 = std::max(std::abs(dx_fx8), std::abs(dy_fx8));
    expect_to_hold_all(claiming_px(moving(dx_fx8, dy_fx8), most_fx8 * kFx16PerFx8), 150);
  }
}

TEST(CoverageAccuracyAtLength, IsKeptByOneThatIsOffAtRandomWithinIt) {
  for (const int32_t most_fx8 : {1, 40, 256}) {
    expect_to_hold_all(claiming_px(moving_at_random(most_fx8), most_fx8 * kFx16PerFx8), 150);
  }
}

TEST(CoverageAccuracy, IsToldHowMuchOfItIsNeeded) {
  const auto margin = [](int32_t claimed_fx8) {
    const Subject subject = claiming_px(moving(64, -64), claimed_fx8 * kFx16PerFx8);
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
    const int32_t claimed_fx16 = off_fx8 * kFx16PerFx8 / 2;
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
  EXPECT_TRUE(is_broken_by(claiming_px(moving(16, 0), 15 * kFx16PerFx8 - 1)));
  EXPECT_FALSE(is_broken_by(claiming_px(moving(16, 0), 15 * kFx16PerFx8)));
  EXPECT_TRUE(breaks("COV", moving(1, 0)));
  EXPECT_TRUE(draws_exactly(Capabilities{}));
}

// Polygons that do not meet have a gap between them or draw pixels twice, however little.
TEST(CoverageAccuracy, LetsSharedEdgesBeExact) {
  const Subject by_outline = covering([](const Drawing& drawing) {
    const selvage_vertex& last = drawing.vertices.back();
    return Point{((last.x ^ last.y) & 1) * 64, 0};
  });
  for (const char* law : {"PART", "PINWHEEL", "SPLIT"}) {
    EXPECT_TRUE(breaks(law, claiming_px(by_outline, SELVAGE_SUBTEXELS / 4))) << law;
  }
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
  EXPECT_EQ(note("CLIP"), "the coverage; texels are within its accuracy (MAP)");
}

}  // namespace
}  // namespace selvage::spec
