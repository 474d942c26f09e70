// The hard families as a whole: repeatable, in range, lawful, and among the fuzz seeds.
#include "spec/hard_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "case_support.h"
#include "fuzz/laws_limits.h"
#include "spec/exact.h"
#include "spec/laws.h"

namespace selvage::spec {
namespace {

// Of each family this case is a fuzz seed: small, and off the whole pixels.
constexpr uint64_t kFuzzSeed = 1;

[[nodiscard]] std::string read(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(HardCases, HaveNamesAndReasonsOfTheirOwn) {
  std::set<std::string_view> names, reasons;
  for (const HardFamily& family : hard_families()) {
    EXPECT_TRUE(names.insert(family.name).second) << family.name;
    EXPECT_TRUE(reasons.insert(family.reason).second) << family.name;
    EXPECT_EQ(find_hard_family(family.name), &family);
    EXPECT_EQ(family.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"),
              std::string_view::npos)
        << family.name;
    EXPECT_GE(family.reason.size(), 40U) << family.reason;
    EXPECT_EQ(family.reason.find(". "), std::string_view::npos) << "one sentence";
    EXPECT_EQ(family.reason.back(), '.') << family.reason;
    EXPECT_EQ(family.reason.find('|'), std::string_view::npos) << "it is a cell of a table";
  }
  EXPECT_EQ(names.size(), 26U);
  EXPECT_EQ(find_hard_family(""), nullptr);
  EXPECT_EQ(find_hard_family("sliver"), nullptr);
}

TEST(HardCases, StandInTheSpecification) {
  const std::string text = read(SELVAGE_SOURCE_DIR "/spec/README.md");
  for (const HardFamily& family : hard_families()) {
    const std::string row =
        "| `" + std::string(family.name) + "` | " + std::string(family.reason) + " |\n";
    EXPECT_NE(text.find(row), std::string::npos) << "spec/README.md lacks\n" << row;
  }
}

// FNV-1a over the encodings. Change it only with a family.
TEST(HardCases, MeanTheSameCasesOnEveryMachine) {
  uint64_t hash = 0xcbf29ce484222325u;
  for (const HardFamily& family : hard_families()) {
    for (uint64_t seed = 0; seed < 50; ++seed) {
      for (const uint8_t byte : encode(family.make(seed))) hash = (hash ^ byte) * 0x100000001b3u;
    }
  }
  EXPECT_EQ(hash, 0x8c7609b486f234e4u);
}

class HardFamilies : public testing::TestWithParam<const HardFamily*> {};

[[nodiscard]] bool is_on_whole_pixels(const Case& c) {
  return std::ranges::all_of(c.vertices,
                             [](const selvage_vertex& v) { return ((v.x | v.y) & 255) == 0; });
}

TEST_P(HardFamilies, StayInRange) {
  const HardFamily& family = *GetParam();
  for (uint64_t seed = 0; seed < 200; ++seed) {
    const Case c = family.make(seed);
    ASSERT_EQ(out_of_range(c), "") << seed;
    ASSERT_EQ(validity(c.vertices), SELVAGE_OK) << seed;
    ASSERT_TRUE(decode(encode(c)) == c) << seed;
    ASSERT_FALSE(c == family.make(seed + 1)) << seed;
    EXPECT_EQ(c.format, SELVAGE_RGBA8888);
    EXPECT_EQ(c.address, SELVAGE_ADDRESS_CLAMP);
    EXPECT_FALSE(c.has_clip);
    if (seed % 4 < 2) {
      EXPECT_LE(c.target_width_px * c.target_height_px, kSmallTargetPx) << seed;
    }
    if (family.name != "near-ties") {
      EXPECT_EQ(is_on_whole_pixels(c), seed % 2 == 0) << seed;
    }
  }
}

// So that no clamping hides what a mapper does.
TEST_P(HardFamilies, ShowTexelsOfTheTexture) {
  for (const uint64_t seed : {0U, 1U, 2U, 3U, 4U, 5U, 8U, 9U, 12U, 13U}) {
    const Case c = GetParam()->make(seed);
    for (int32_t y = 0; y < c.target_height_px; ++y) {
      const std::optional<ScanLine> line = scan_line(c.vertices, y);
      for (int32_t x = 0; line && x < c.target_width_px; ++x) {
        const std::optional<Sample> point = sample(*line, x);
        if (!point) continue;
        ASSERT_TRUE(0 <= point->u && point->u < c.texture_width_texel) << seed;
        ASSERT_TRUE(0 <= point->v && point->v < c.texture_height_texel) << seed;
      }
    }
  }
}

// All laws on small targets; on large ones those that draw little.
TEST_P(HardFamilies, AreLawful) {
  const std::set<std::string_view> cheap = {"COV", "MAP", "CLIP", "MEM"};
  const Subject mapper = built_in();
  for (uint64_t seed = 0; seed < 8; ++seed) {
    const Case c = GetParam()->make(seed);
    const bool small = c.target_width_px * c.target_height_px <= kSmallTargetPx;
    for (const Law& law : laws()) {
      if (!small && !cheap.contains(law.name)) continue;
      const Judgement judgement = law.check(mapper, c);
      ASSERT_FALSE(judgement.violation)
          << explain(*judgement.violation) << "\nreplay: selvage verify --law " << law.name
          << " --case " << to_hex(c);
      if (law.name == "MAP") {
        EXPECT_GT(judgement.judged_px, 0U) << "nothing is covered: seed " << seed;
      }
    }
  }
}

TEST_P(HardFamilies, AreFuzzSeeds) {
  const Case c = GetParam()->make(kFuzzSeed);
  ASSERT_TRUE(fuzz::is_taken(c));
  const std::string path = "fuzz/seeds/laws/family_" + std::string(GetParam()->name);
  const std::string bytes = read(SELVAGE_SOURCE_DIR "/" + path);
  const std::vector<uint8_t> wanted = encode(c);
  EXPECT_TRUE(std::equal(wanted.begin(), wanted.end(), bytes.begin(), bytes.end(),
                         [](uint8_t a, char b) { return a == static_cast<uint8_t>(b); }))
      << "to write it: xxd -r -p <<< " << to_hex(c) << " > " << path;
}

[[nodiscard]] std::vector<const HardFamily*> every_family() {
  std::vector<const HardFamily*> all;
  for (const HardFamily& family : hard_families()) all.push_back(&family);
  return all;
}

[[nodiscard]] std::string test_name(const testing::TestParamInfo<const HardFamily*>& info) {
  std::string name(info.param->name);
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Exact, HardFamilies, testing::ValuesIn(every_family()), test_name);

}  // namespace
}  // namespace selvage::spec
