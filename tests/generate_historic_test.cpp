// The generator of cases for a profile: repeatable, in range, and of what is hard for it enough.
#include "spec/generate_historic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "case_support.h"
#include "spec/dda.h"
#include "spec/generate.h"
#include "spec/model.h"
#include "spec/profiles.h"

namespace selvage::spec {
namespace {

inline constexpr uint64_t kSeeds = 6000;

[[nodiscard]] std::vector<Case> cases_of(selvage_profile id) {
  std::vector<Case> cases;
  for (uint64_t seed = 0; seed < kSeeds; ++seed) cases.push_back(generate(seed, id));
  return cases;
}

void expect_share(const std::vector<Case>& cases, const char* what, double least_percent,
                  double most_percent, bool (*holds)(const Case&)) {
  const auto count = std::ranges::count_if(cases, holds);
  const double percent = 100.0 * static_cast<double>(count) / static_cast<double>(cases.size());
  EXPECT_GE(percent, least_percent) << what;
  EXPECT_LE(percent, most_percent) << what;
}

TEST(GenerateHistoric, StaysInRange) {
  for (const Profile& profile : profiles()) {
    for (const Case& c : cases_of(profile.id)) {
      ASSERT_EQ(out_of_range(c), "") << to_hex(c);
      ASSERT_EQ(c.profile, profile.id);
      ASSERT_TRUE(decode(encode(c)) == c) << to_hex(c);
    }
  }
}

TEST(GenerateHistoric, LeavesTheExactProfileAlone) {
  for (uint64_t seed = 0; seed < kSeeds; ++seed) {
    EXPECT_TRUE(generate(seed, SELVAGE_PROFILE_EXACT) == generate(seed)) << seed;
  }
}

// An invalid outline may be one for its edges alone.
TEST(GenerateHistoric, KeepsToWholePixelsAndEqualQ) {
  for (const Profile& profile : profiles().subspan(1)) {
    for (const Case& c : cases_of(profile.id)) {
      ASSERT_NE(validity(c), SELVAGE_ERROR_VERTEX_FRACTION) << to_hex(c);
      ASSERT_NE(validity(c), SELVAGE_ERROR_VERTEX_Q_DIFFERS) << to_hex(c);
    }
  }
}

// FNV-1a over the encodings, as for the exact profile: change it only with the generators.
TEST(GenerateHistoric, MeansTheSameCasesOnEveryMachine) {
  uint64_t hash = 0xcbf29ce484222325u;
  for (const Profile& profile : profiles().subspan(1)) {
    for (const Case& c : cases_of(profile.id)) {
      for (const uint8_t byte : encode(c)) hash = (hash ^ byte) * 0x100000001b3u;
    }
  }
  EXPECT_EQ(hash, 0x170e20b907d2c575u);
}

[[nodiscard]] bool is_long(const Case& c) {
  return std::max(c.target_width_px, c.target_height_px) > 128;
}

[[nodiscard]] bool is_copied(const Case& c) { return centred_block_shift(c.vertices).has_value(); }

// Some pixel's texel is another one if all of u is so many units more.
[[nodiscard]] bool changes(const Case& c, int32_t units) {
  Case other = c;
  for (selvage_vertex& v : other.vertices) {
    const int64_t u = int64_t{v.u} + units;
    if (u != static_cast<int32_t>(u)) return false;
    v.u = static_cast<int32_t>(u);
  }
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    const auto line = historic_line(c.profile, c.vertices, y);
    const auto changed = historic_line(c.profile, other.vertices, y);
    for (int32_t x = 0; line && x < c.target_width_px; ++x) {
      if (dda_texel(*line, x) != dda_texel(*changed, x)) return true;
    }
  }
  return false;
}

[[nodiscard]] bool grazes(const Case& c) {
  return is_valid(c) && (changes(c, 1) || changes(c, -1));
}

TEST(GenerateHistoricAtLength, ReachesWhatIsHard) {
  for (const Profile& profile : profiles().subspan(1)) {
    const std::vector<Case> cases = cases_of(profile.id);
    expect_share(cases, "targets of hundreds of pixels", 4, 9, is_long);
    expect_share(cases, "rectangles of as many texel centres as pixels", 0.5, 8, is_copied);
    expect_share(cases, "a unit of u shows", 18, 50, grazes);
  }
}

}  // namespace
}  // namespace selvage::spec
