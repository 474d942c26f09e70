// The bounds of spec/proofs, proved by Gappa with the constants of the code. Each claimed bound is
// then made wrong, and each assumption too weak, one at a time: the proof must fail.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "mapper/affine_slab.h"
#include "mapper/bend.h"
#include "mapper/edge.h"
#include "mapper/filter_point.h"
#include "mapper/footprint.h"
#include "mapper/lanes.h"
#include "mapper/near_plane.h"
#include "mapper/plane.h"
#include "mapper/plane_footprint.h"
#include "mapper/projective_plane.h"
#include "mapper/projective_slab.h"
#include "mapper/sums.h"
#include "mapper/to_double.h"
#include "mapper/tolerance.h"
#include "mapper/vector/kernel.h"
#include "spec/dda_bounds.h"
#include "spec/oracle.h"
#include "tests/gappa.h"

namespace selvage {
namespace {

using namespace spec;
using namespace mapper;

// What a script calls @NAME@; `wrong` is empty for what no claim of the script hangs on closely.
struct Constant {
  std::string name, value, wrong = "";
};

struct Proof {
  std::string script;
  std::vector<Constant> constants;
  std::string use = "";  // of several

  [[nodiscard]] std::string name() const { return script + use; }
};
void PrintTo(const Proof& proof, std::ostream* out) { *out << proof.name(); }

// Exactly, in Gappa's notation.
[[nodiscard]] std::string number(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%a", value);
  return text.data();
}
[[nodiscard]] std::string number(int64_t value) { return std::to_string(value); }
[[nodiscard]] std::string number(int value) { return std::to_string(value); }

// A bound that is reached is wrong as soon as it is less, and one that is larger than it has to be
// is found out by this not failing.
[[nodiscard]] std::string barely_less(double bound) { return number(bound - 0x1p-7); }

inline constexpr int kCoordinateBits = kTexelBits - kTexelFraction;  // |u| <= 2^15 texels
inline constexpr int64_t kLongest_fx8 = int64_t{SELVAGE_X_END} - 1 - SELVAGE_X_MIN;

[[nodiscard]] std::vector<Proof> historic_proofs() {
  const auto below = [](selvage_profile profile) {
    return whole_column_error(profile).below_halves / 2.0;
  };
  const auto above = [](selvage_profile profile) {
    return whole_column_error(profile).above_halves / 2.0;
  };
  const Constant row{"ROW", number(kUlpsPerRow), barely_less(kUlpsPerRow)};
  const Constant prestep{"PRESTEP", number(kUlpsPerPrestep), barely_less(kUlpsPerPrestep)};
  return {
      {"dda_edge", {row, prestep}},
      {"dda_span",
       {{row.name, row.value},
        prestep,
        {"PIXEL", number(kUlpsPerPixel), barely_less(kUlpsPerPixel)}}},
      {"dda_whole_columns",
       {{"BELOW_56", number(below(SELVAGE_PROFILE_ABRASH56)),
         barely_less(below(SELVAGE_PROFILE_ABRASH56))},
        {"ABOVE_56", number(above(SELVAGE_PROFILE_ABRASH56)),
         barely_less(above(SELVAGE_PROFILE_ABRASH56))},
        {"BELOW_57", number(below(SELVAGE_PROFILE_ABRASH57)),
         barely_less(below(SELVAGE_PROFILE_ABRASH57))},
        {"ABOVE_57", number(above(SELVAGE_PROFILE_ABRASH57)),
         barely_less(above(SELVAGE_PROFILE_ABRASH57))},
        {"BELOW_DKIT", number(below(SELVAGE_PROFILE_DKIT)),
         barely_less(below(SELVAGE_PROFILE_DKIT))},
        {"ABOVE_DKIT", number(above(SELVAGE_PROFILE_DKIT)),
         barely_less(above(SELVAGE_PROFILE_DKIT))},
        {"DKIT_ROUNDING", number(kDkitRoundingHalves / 2.0),
         barely_less(kDkitRoundingHalves / 2.0)}}},
  };
}

[[nodiscard]] Proof coarse_lanes(int bits) {
  return {"coarse_lanes",
          {{"BITS", number(bits)},
           {"TRUNCATIONS", number(kCoarseTruncations), barely_less(kCoarseTruncations)}},
          "_of_" + std::to_string(bits)};
}

// A plane's, or a slab's, which has two roundings more.
[[nodiscard]] Proof projective_plane(const std::string& use, double ruled, double roundings,
                                     double per_reach, const std::string& too_little) {
  return {"projective_plane",
          {{"Q_BITS", number(kQBits)},
           {"LANE_BITS", number(kCoordinateBits + kLaneFraction), "48"},
           {"CONVERSION", number(kPlaneConversionRoundings * 0x1p-53), "0x4p-53"},
           {"RULED", number(ruled), "0x2p-53"},
           {"SUM", number(roundings * 0x1p-53), number((roundings - 0.5625) * 0x1p-53)},
           {"MOST_REACH", number(kMostReach), "0x1p47"},
           {"PER_REACH", number(per_reach), too_little},
           {"TRUNCATIONS", number(kProjectiveTruncations_fx32), "1"}},
          use};
}

[[nodiscard]] Proof plane_quotient(const std::string& use, int shift) {
  return {"plane_quotient",
          {{"SHIFT", number(shift)},
           {"AREA_BITS", number(kPlaneAreaBits)},
           {"ROUND_TO_WHOLE", number(kRoundToWhole)},
           {"MOST", number(2 * kMostRounded_fx32), "0x1.1p51"},
           {"ERROR", number(kRoundedError_fx32), "0.74"}},
          use};
}

// What a form of a small triangle is off by in single precision, of the most that it can be.
inline constexpr double kSmallSum = 0x4.0001p-24;

[[nodiscard]] std::vector<Proof> mapper_proofs() {
  const Constant lane_fraction{"LANE_FRACTION", number(kLaneFraction)};
  const Constant denominator_bits{"DENOMINATOR_BITS", number(kDenominatorBits)};
  const Constant q_bits{"Q_BITS", number(kQBits)};
  return {
      {"affine_lanes",
       {denominator_bits,
        {"PER_PIXEL", number(int64_t{kAffineErrorPerPixel_fx32}),
         barely_less(kAffineErrorPerPixel_fx32)}}},
      {"ruled_rows",
       {{"LANE_BITS", number(kCoordinateBits + kLaneFraction), "48"},
        {"ERROR", number(kRuledError_fx32), "0.34"},
        {"SLACK", number(kRuledSlack_fx32), "0.35"},
        {"PER_PIXEL", number(int64_t{kRuledErrorPerPixel_fx32}), "1.85"}}},
      {"quotient",
       {{"CONVERSION", number(kConversionRoundings * 0x1p-53), "0x4p-53"},
        {"QUOTIENT_BITS", number(kCoordinateBits + 1 + kLaneFraction), "51"},
        {"ERROR", number(kEstimateError_fx32), "0.2"}}},
      {"projective_lanes",
       {lane_fraction,
        denominator_bits,
        q_bits,
        {"LANE_BITS", number(kCoordinateBits + kLaneFraction), "49"},
        {"PER_RATIO", number(kProjectiveErrorPerRatio_fx32), "0.18"},
        {"TRUNCATIONS", number(kProjectiveTruncations_fx32), "0"}}},
      {"plane_lanes",
       {{"AREA_BITS", number(kPlaneAreaBits)},
        {"PER_STEP", number(int64_t{kPlaneErrorPerStep_fx32}),
         barely_less(kPlaneErrorPerStep_fx32)}}},
      {"vector_lanes",
       {{"SHIFT", number(kLaneFraction - kTexelFraction)},
        {"TRUNCATIONS", number(kVectorTruncations_fx16), barely_less(kVectorTruncations_fx16)}}},
      {"vector_lanes",
       {{"SHIFT", number(kWindowShift)},
        {"TRUNCATIONS", number(kVectorTruncations_fx24), barely_less(kVectorTruncations_fx24)}},
       "_fx24"},
      {"near_plane",
       {{"SHIFT", number(kSubpixelBits)},
        {"TRUNCATION", number(kNearTruncation_fx32), barely_less(kNearTruncation_fx32)}}},
      {"common_step",
       {{"LAST", number(int64_t{kMostLanes - 1})},
        {"STEPS", number(int64_t{kMostLanes - 1}), barely_less(kMostLanes - 1)}}},
      {"fine_lanes",
       {{"SHIFT", number(kWindowShift)},
        {"TRUNCATIONS", number(kVectorTruncations_fx24), barely_less(kVectorTruncations_fx24)}}},
      coarse_lanes(1),
      coarse_lanes(2),
      coarse_lanes(3),
      coarse_lanes(kMostCoarseTexelBits),
      {"divided_lanes",
       {{"SHIFT", number(kLaneFraction - kTexelFraction)},
        {"LANE_BITS", number(kTexelBits + 1), "38"},
        {"SPARE", number(kProjectiveTruncations_fx32 - 1), "0"},
        {"TRUNCATIONS", number(kDividedTruncations_fx16), barely_less(kDividedTruncations_fx16)}}},
      {"divided_lanes",
       {{"SHIFT", number(kLaneFraction - kWindowFraction)},
        {"LANE_BITS", number(kTexelBits - kTexelFraction + kWindowFraction + 1), "46"},
        {"SPARE", number(kProjectiveTruncations_fx32 - 1), "0"},
        {"TRUNCATIONS", number(kDividedTruncations_fx24), barely_less(kDividedTruncations_fx24)}},
       "_fx24"},
      {"anchored_lanes",
       {{"LANE_BITS", number(kTexelBits), "45"},
        {"MOST_TURN", number(kMostTurn), "0.52"},
        {"MOST_WALK", number(kMostWalk_fx16)},
        {"ROUNDINGS", number(kAnchoredRoundings), "5.9"},
        {"SLACK", number(kAnchoredSlack_fx16), "0.5"},
        {"TRUNCATIONS", number(kAnchoredTruncations_fx16),
         barely_less(kAnchoredTruncations_fx16)}}},
      {"small_projective",
       {{"SUM", number(kSmallSum), "0x4p-24"},
        {"PRODUCT", number(kSmallQuotientRoundings), "11.25"},
        {"ROUNDINGS", number(kSmallRoundings), "12.25"},
        {"SLACK", number(kSmallSlack_fx24), "0.26"},
        {"TRUNCATIONS", number(kSmallTruncations_fx24), "1.9"},
        {"FORMS", number(kSmallForms_fx24), "0.3"},
        {"MOST_RATIO", number(kSmall.most_q_ratio)},
        {"MOST_DEPTH", number(kMostSmallDepth), "0x1p20"},
        {"MOST_ERROR", number(kMostSmallError_fx24)}}},
      {"small_forms",
       {{"TEXEL_BITS", number(kSmallTexelBits), "23"},
        {"PLACE_BITS", number(kSmallPlaceBits), "14"},
        {"AREA_BITS", number(kSmallAreaBits), "30"},
        {"FORM", number(kSmallForm), "0.4"}}},
      {"stepped_lanes",
       {{"SHIFT", number(kStepShift)},
        {"TRUNCATIONS", number(kStepTruncations_fx16), barely_less(kStepTruncations_fx16)},
        {"STEP_ERROR", number(kStepError_fx32), "0.99"}}},
      {"chord_bound",
       {{"CONVERSION", number(kPlaneConversionRoundings * 0x1p-53), "0x4p-53"},
        {"SLOPE_ERROR", number(kSlopeError), "0x1p-50"},
        {"BEND_SLACK", number(kBendSlack), "0x1.0000004p0"},
        {"BUDGET_SLACK", number(kBudgetSlack), "0x1p0"}}},
      {"plane_estimate",
       {{"FRACTION", number(kTexelFraction)},
        {"SUBPIXEL_BITS", number(kSubpixelBits)},
        {"AREA_BITS", number(kPlaneAreaBits)},
        {"POSITION_BITS", number(kPositionBits + 1)},
        {"MOST", number(kMostPlaneEstimate_fx32), "0x1p53"},
        {"ERROR", number(kPlaneEstimateError_fx32), "4.9"}}},
      plane_quotient("", kPlaneStepShift),
      plane_quotient("_of_start", kPlaneStartShift),
      plane_quotient("_unscaled", 0),
      projective_plane("", 0, kPlaneRoundings, kPlaneErrorPerReach_fx32, "0.29"),
      projective_plane("_of_slab", 0x1p-53, kSlabRoundings, kSlabErrorPerReach_fx32, "0.35"),
      {"edge_quotient",
       {{"COLUMN_BITS", number(kColumnBits), "22"},
        {"COLUMN_DIVISOR_BITS", number(kColumnDivisorBits), "37"},
        {"STEP_BITS", number(kStepBits), "30"},
        {"STEP_DIVISOR_BITS", number(kStepDivisorBits), "29"}}},
      {"edge_reciprocal",
       {{"COLUMN_BITS", number(kColumnBits), "20"},
        {"DIVISOR_BITS", number(kColumnDivisorBits), "34"}}},
      {"box_mean", {{"AREA_BITS", number(2 * kSummedSideBits), "42"}}},
      {"footprint", {{"ROUNDINGS", number(kFootprintRoundings), number(kFootprintRoundings - 2)}}},
      {"plane_footprint",
       {{"CONVERSION", number(kPlaneConversionRoundings * 0x1p-53), "0x5p-53"},
        {"SUM", number(kPlaneRoundings * 0x1p-53), "0xa.2p-53"},
        {"ROUNDINGS", number(kSideRoundings), "18"},
        {"TRUNCATIONS", number(kProjectiveTruncations_fx32), "1"},
        {"LEAST_SHARE", number(0.5 / kMostReach), "0x1p-60"}}},
      {"filter_grid",
       {{"GRID_FRACTION", number(kGridFraction)},
        {"WIDEST", number(kWidestMargin_fx32), "50331649"}}},
      {"filter", {lane_fraction, {"WIDEST", number(kWidestMargin_fx32), "4294967297"}}},
      {"numerator_bits",
       {q_bits,
        {"TEXEL_FRACTION", number(kTexelFraction), "17"},
        {"COLUMN_BITS", number(kCoordinateBits), "16"},
        {"UQ_BITS", number(kTexelBits + kQBits), "56"},
        {"LONGEST", number(kLongest_fx8), "16777216"},
        {"NUMERATOR_BITS", number(kNumeratorBits), "126"}}},
      {"snap", {{"FRACTION_BITS", number(std::numeric_limits<double>::digits - 1), "53"}}},
  };
}

[[nodiscard]] std::vector<Proof> oracle_proofs() {
  return {
      {"oracle_affine",
       {{"ROUNDING", number(kAffineRounding_texel), "0x0.ffp-10"},
        {"ROUNDINGS", number(kAffineRoundings), "3"},
        {"LARGEST_TERM", number(2 * kLargestSum_texel), "0x1p39"}}},
      {"oracle_projective",
       {{"FACTOR", number(kProjectiveFactor), "1"},
        {"TERMS", number(kProjectiveTerms), "1"},
        {"QUOTIENT", number(kProjectiveQuotient), "0"}}},
  };
}

[[nodiscard]] std::vector<Proof> proofs() {
  std::vector<Proof> all;
  for (const auto& some : {historic_proofs(), mapper_proofs(), oracle_proofs()}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

[[nodiscard]] std::string text_of(const std::string& file_name) {
  std::ifstream file(std::filesystem::path(SELVAGE_PROOFS) / file_name);
  EXPECT_TRUE(file) << SELVAGE_PROOFS << "/" << file_name;
  return (std::ostringstream() << file.rdbuf()).str();
}

// The script with values for its names, all of which must occur. (A name without a value would be a
// syntax error to Gappa.)
[[nodiscard]] std::string filled(const Proof& proof) {
  std::string text = text_of(proof.script + ".g");
  for (const Constant& constant : proof.constants) {
    const std::string name = "@" + constant.name + "@";
    size_t at = text.find(name);
    EXPECT_NE(at, std::string::npos) << proof.script << " does not use " << name;
    for (; at != std::string::npos; at = text.find(name, at)) {
      text.replace(at, name.size(), constant.value);
    }
  }
  return text;
}

class Proofs : public testing::TestWithParam<Proof> {
 protected:
  void SetUp() override {
    if (std::string(SELVAGE_GAPPA).empty()) {
      GTEST_SKIP() << "No bound was proved: CMake found no gappa (Debian package gappa).";
    }
  }
};

// A warning is a failure too: Gappa takes a rewriting rule that it cannot verify on trust.
TEST_P(Proofs, HoldWithTheConstantsOfTheCode) {
  const std::string text = filled(GetParam());
  const Verdict verdict = ask_gappa(SELVAGE_GAPPA, text);
  EXPECT_TRUE(verdict.status == 0 && verdict.output.empty())
      << "gappa: status " << verdict.status << "\n"
      << verdict.output << "\n"
      << text;
}

TEST_P(Proofs, FailWithAWrongConstant) {
  int wrong_constants = 0;
  for (size_t i = 0; i < GetParam().constants.size(); ++i) {
    Proof wrong = GetParam();
    Constant& constant = wrong.constants[i];
    if (constant.wrong.empty()) continue;
    ++wrong_constants;
    const std::string change = constant.name + " = " + constant.wrong + " for " + constant.value;
    constant.value = constant.wrong;
    const std::string text = filled(wrong);
    const Verdict verdict = ask_gappa(SELVAGE_GAPPA, text);
    const bool refused =
        verdict.output.find("some properties were not satisfied") != std::string::npos;
    EXPECT_TRUE(verdict.status == 1 && refused)
        << "gappa accepts " << change << ", or fails for another reason: status " << verdict.status
        << "\n"
        << verdict.output << "\n"
        << text;
  }
  EXPECT_GT(wrong_constants, 0);
}

INSTANTIATE_TEST_SUITE_P(, Proofs, testing::ValuesIn(proofs()),
                         [](const auto& proof) { return proof.param.name(); });

TEST(ProofScripts, AreAllRunAndAllExplained) {
  std::set<std::string> run, found;
  for (const Proof& proof : proofs()) run.insert(proof.script);
  const std::string readme = text_of("README.md");
  for (const auto& entry : std::filesystem::directory_iterator(SELVAGE_PROOFS)) {
    if (entry.path().extension() != ".g") continue;
    found.insert(entry.path().stem().string());
    EXPECT_NE(readme.find("(" + entry.path().filename().string() + ")"), std::string::npos)
        << "spec/proofs/README.md does not link " << entry.path().filename();
  }
  EXPECT_EQ(run, found);
}

}  // namespace
}  // namespace selvage
