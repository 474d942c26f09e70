// A valid polygon is answered by SELVAGE_OK: each law objects to anything else, and says to what.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "spec/capabilities.h"
#include "spec/laws.h"
#include "spec/model.h"
#include "spec/status_name.h"
#include "spec/verify.h"

namespace selvage::spec {
namespace {

const std::string kTold =
    "it returned 3 (SELVAGE_ERROR_TARGET_SIZE) for a valid polygon; 0 (SELVAGE_OK) is right";

constexpr size_t kNone = std::string::npos;

// Draws all that is right to draw.
[[nodiscard]] Subject answering_errors(selvage_profile profile) {
  Subject subject = built_in(profile);
  subject.draw = [](auto... arguments) -> selvage_status {
    const selvage_status status = selvage_draw(arguments...);
    return status == SELVAGE_OK ? SELVAGE_ERROR_TARGET_SIZE : status;
  };
  return subject;
}

TEST(Refusal, OfWhatWasDrawnIsAViolationOfEveryLaw) {
  for (const Profile& profile : profiles()) {
    for (const Law& law : laws()) {
      if (!is_promised(profile.id, law.name)) continue;
      const LawVerdict verdict = verify(law, answering_errors(profile.id), 1, 60);
      ASSERT_TRUE(verdict.violation) << profile.name << ": " << law.name;
      EXPECT_EQ(verdict.violation->law, law.name);
      if (law.name == "TOTAL") {  // a call of its own may be the smaller counterexample
        EXPECT_NE(verdict.violation->drawn.find("3 (SELVAGE_ERROR_TARGET_SIZE)"), kNone);
        continue;
      }
      EXPECT_EQ(verdict.violation->drawn, kTold) << law.name;
      EXPECT_EQ(verdict.violation->allowed, "0 (SELVAGE_OK)");
      EXPECT_TRUE(is_valid(verdict.violation->shown)) << print(verdict.violation->shown);
      EXPECT_GT(verdict.judged_px, 0u);
    }
  }
}

// Over one background it is drawn, over the other it is not.
TEST(Refusal, OfEverySeventhCallIsSeenByCoverage) {
  for (const char* law : {"COV", "PART", "PINWHEEL"}) {
    const auto calls = std::make_shared<int>(0);
    Subject subject = built_in();
    subject.draw = [calls](auto... arguments) -> selvage_status {
      return ++*calls % 7 == 0 ? SELVAGE_ERROR_TARGET_SIZE : selvage_draw(arguments...);
    };
    const LawVerdict verdict = verify(*find_law(law), subject, 1, 60);
    ASSERT_TRUE(verdict.violation) << law;
    EXPECT_EQ(verdict.violation->drawn, kTold);
  }
}

TEST(Refusal, OfWhatIsNotValidIsRight) {
  const Case nothing;  // has no vertices
  EXPECT_FALSE(judge(*find_law("MEM"), built_in(), nothing).violation);
  EXPECT_FALSE(judge(*find_law("TOTAL"), built_in(), nothing).violation);
}

TEST(StatusName, IsThatOfTheHeader) {
  std::ifstream file(SELVAGE_SOURCE_DIR "/src/selvage/status.h");
  ASSERT_TRUE(file);
  selvage_status status = 0;
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("  SELVAGE_OK") && !line.starts_with("  SELVAGE_ERROR_")) continue;
    const std::string name = line.substr(2, line.find_first_of(" ,", 2) - 2);
    EXPECT_EQ(status_name(status), std::to_string(status) + " (" + name + ")");
    ++status;
  }
  EXPECT_EQ(status, SELVAGE_STATUS_COUNT);
  EXPECT_EQ(status_name(SELVAGE_STATUS_COUNT),
            std::to_string(SELVAGE_STATUS_COUNT) + " (no selvage_status)");
  EXPECT_EQ(status_name(-1), "-1 (no selvage_status)");
}

// Tiles that reach a pixel too far to the right overlap.
TEST(Part, TellsInWordsHowOftenAPixelWasDrawn) {
  Subject wide = built_in();
  wide.draw = [](const selvage_image* target, const selvage_rect* clip,
                 const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                 const selvage_options* options) {
    std::vector<selvage_vertex> wider(vertices, vertices + count);
    if (count > 0) std::ranges::max_element(wider, {}, &selvage_vertex::x)->x += SELVAGE_SUBPIXELS;
    return selvage_draw(target, clip, wider.data(), count, texture, options);
  };
  const LawVerdict verdict = verify(*find_law("PART"), wide, 1, 200);
  ASSERT_TRUE(verdict.violation);
  const std::string told = verdict.violation->allowed + "; " + verdict.violation->drawn;
  EXPECT_NE(verdict.violation->allowed.find("tiles draw it "), kNone) << told;
  EXPECT_TRUE(told.ends_with("times") || told.ends_with("once") || told.ends_with("never")) << told;
  EXPECT_EQ(told.find("-1"), kNone) << told;
}

}  // namespace
}  // namespace selvage::spec
