#include "cli/stability_command.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/picture_file.h"
#include "reports/stability/contender.h"
#include "spec/hard_cases.h"
#include "support.h"
#include "wrong_subjects.h"

namespace selvage::cli::test {
namespace {

using Names = std::vector<std::string>;

// Small, and nearly every arithmetic errs on it.
[[nodiscard]] std::string a_family() { return "flat-topped"; }

class Stability : public InDirectory {
 protected:
  Stability() {
    options_.families = {a_family()};
    options_.cases = "2";
    options_.seed = "5";
  }

  int run(const spec::Subject& subject = spec::built_in()) {
    out_.str("");
    err_.str("");
    return run_stability(options_, subject, {out_, err_});
  }
  [[nodiscard]] std::string out() const { return out_.str(); }
  [[nodiscard]] std::string err() const { return err_.str(); }
  [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(out()); }

  // The cell of an arithmetic in the first family.
  [[nodiscard]] nlohmann::json cell(const std::string& arithmetic) const {
    const nlohmann::json values = json();
    for (const auto& cell : values["families"][0]["cells"])
      if (cell["arithmetic"] == arithmetic) return cell;
    ADD_FAILURE() << "no cell of " << arithmetic;
    return {};
  }

  StabilityOptions options_;

 private:
  std::ostringstream out_, err_;
};

TEST_F(Stability, OfTheBuiltInMapperKeepsItsPromises) {
  EXPECT_EQ(run(), kExitFine) << out();
  expect_contains(out(), "seed 5, 2 scenes of each family\n");
  expect_contains(out(), a_family() + ": ");
  for (const auto& contender : stability::contenders(spec::built_in()))
    expect_contains(out(), "\n" + std::string(contender.name) + " ");
  expect_contains(out(), "float32-plane draws n-gons as fans of triangles");
  EXPECT_EQ(out().find("BROKEN"), std::string::npos);
  EXPECT_EQ(err(), "");
  EXPECT_EQ(files(), Names{});
}

TEST_F(Stability, FitsAHundredColumns) {
  options_.seed = "18446744073709551610";
  run();
  std::istringstream lines{out()};
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
}

TEST_F(Stability, FindsAnExactProfileThatIsNot) {
  options_.arithmetics = {"float64-dda", "exact"};
  EXPECT_EQ(run(shifted_texture(1)), kExitLawFailed);
  expect_contains(out(), "BROKEN: exact on " + a_family() +
                             ": a pixel differs from the exact model; again: selvage stability "
                             "--family " +
                             a_family() + " --arithmetic exact --seed ");
  options_.arithmetics = {"float64-dda"};
  EXPECT_EQ(run(shifted_texture(1)), kExitFine) << "which is none of the mapper's profiles";
}

TEST_F(Stability, FindsAnEmptyPicture) {
  options_.arithmetics = {"exact"};
  options_.json = true;
  EXPECT_EQ(run(blank()), kExitLawFailed);
  EXPECT_EQ(json()["passed"], false);
  EXPECT_EQ(cell("exact")["kept"], false);
  EXPECT_EQ(cell("exact")["compared_px"], 0);
  EXPECT_EQ(cell("exact")["missing_px"], json()["families"][0]["covered_px"]);
}

TEST_F(Stability, FindsABoundThatIsNotKept) {
  options_.arithmetics = {"abrash56", "abrash57", "dkit"};
  options_.json = true;
  EXPECT_EQ(run(), kExitFine);
  for (const std::string& profile : options_.arithmetics) {
    EXPECT_LE(cell(profile)["part_of_bound"], 1.0);
    EXPECT_GT(cell(profile)["part_of_bound"], 0.0);
  }
  EXPECT_EQ(run(shifted_texture(30000)), kExitLawFailed);
  EXPECT_EQ(cell("abrash56")["kept"], false);
  options_.json = false;
  run(shifted_texture(30000));
  expect_contains(out(), "ABOVE 1");
  expect_contains(out(), "a texel is beyond the derived bound");
}

TEST_F(Stability, ReportsARefusal) {
  const spec::Subject refuser{
      "refuser",
      [](const selvage_image*, const selvage_rect*, const selvage_vertex*, size_t,
         const selvage_texture*,
         const selvage_options*) -> selvage_status { return SELVAGE_ERROR_NOT_MONOTONE; }};
  options_.arithmetics = {"dkit"};
  EXPECT_EQ(run(refuser), kExitLawFailed);
  expect_contains(out(), "2 scenes refused");
}

TEST_F(Stability, ReportsInJson) {
  options_.json = true;
  EXPECT_EQ(run(), kExitFine);
  const nlohmann::json values = json();
  EXPECT_EQ(values["subject"], spec::built_in().name);
  EXPECT_EQ(values["passed"], true);
  EXPECT_EQ(values["seed"], 5);
  EXPECT_EQ(values["cases"], 2);
  expect_contains(values["notes"], "fixed1616 drops q");
  ASSERT_EQ(values["arithmetics"].size(), 8u);
  EXPECT_EQ(values["arithmetics"][0]["promise"], "bound");
  EXPECT_EQ(values["arithmetics"][3]["promise"], "none");
  EXPECT_EQ(values["arithmetics"][7]["promise"], "exact");
  ASSERT_EQ(values["families"].size(), 1u);
  EXPECT_EQ(values["families"][0]["family"], a_family());
  EXPECT_EQ(values["families"][0]["reason"], spec::find_hard_family(a_family())->reason);
  EXPECT_GT(values["families"][0]["covered_px"], 0);
  for (const char* key : {"compared_px", "wrong_texels", "wrong_share", "largest_texel",
                          "mean_texel", "missing_px", "extra_px"}) {
    EXPECT_TRUE(cell("fixed1616")[key].is_number()) << key;
  }
  EXPECT_FALSE(cell("fixed1616").contains("part_of_bound"));
  EXPECT_TRUE(cell("dkit").contains("part_of_bound"));
  EXPECT_FALSE(cell("exact").contains("worst"));
  EXPECT_EQ(err(), "");
}

// The worst case of a cell, run again by the line that names it, is the same case.
TEST_F(Stability, NamesItsWorstCasesSoThatTheyCanBeRunAgain) {
  options_.json = true;
  options_.cases = "4";
  options_.arithmetics = {"abrash56"};
  run();
  const nlohmann::json worst = cell("abrash56")["worst"];
  const uint64_t seed = worst["seed"];
  EXPECT_GE(seed, 5u);
  EXPECT_LT(seed, 9u);
  EXPECT_EQ(worst["command"], "selvage stability --family " + a_family() +
                                  " --arithmetic abrash56 --seed " + std::to_string(seed) +
                                  " --cases 1");
  options_.cases = "1";
  options_.seed = std::to_string(seed);
  run();
  EXPECT_EQ(cell("abrash56")["largest_texel"], worst["largest_texel"]);
  EXPECT_EQ(cell("abrash56")["wrong_share"], worst["wrong_share"]);
  EXPECT_EQ(cell("abrash56")["worst"], worst);
}

TEST_F(Stability, WithTheSameSeedIsTheSame) {
  options_.json = true;
  run();
  const std::string first = out();
  run();
  EXPECT_EQ(out(), first);
  options_.seed = "77";
  run();
  EXPECT_NE(out(), first);
}

TEST_F(Stability, PrintsTheFreshSeedItTook) {
  options_.seed.clear();
  options_.cases = "1";
  options_.arithmetics = {"exact"};
  options_.json = true;
  run();
  const uint64_t seed = json()["seed"];
  run();
  EXPECT_NE(json()["seed"], seed);
}

TEST_F(Stability, TakesWhatWasAskedForOnce) {
  options_.families = {a_family(), a_family()};
  options_.arithmetics = {"exact", "dkit", "exact"};
  options_.json = true;
  EXPECT_EQ(run(), kExitFine);
  EXPECT_EQ(json()["families"].size(), 1u);
  ASSERT_EQ(json()["families"][0]["cells"].size(), 2u);
  EXPECT_EQ(json()["families"][0]["cells"][0]["arithmetic"], "exact");
  EXPECT_EQ(json()["families"][0]["cells"][1]["arithmetic"], "dkit");
}

TEST_F(Stability, DrawsTheWorstCase) {
  options_.picture = "worst.png";
  options_.arithmetics = {"abrash56"};
  EXPECT_EQ(run(), kExitFine);
  expect_contains(out(), "picture: worst.png (drawn | exact | difference) of " + a_family() +
                             " by abrash56, seed ");
  const Raster worst = read_picture("worst.png");
  options_.arithmetics = {"exact"};
  options_.picture = "right.png";
  run();
  EXPECT_EQ(files(), (Names{"right.png", "worst.png"}));
  EXPECT_NE(read_picture("right.png"), worst);
}

TEST_F(Stability, RefusesAPictureItCannotWriteBeforeItStarts) {
  options_.picture = "nowhere/worst.png";
  expect_contains(error_of([&] { run(); }), "there is no directory 'nowhere'");
  for (const char* name : {"worst.txt", "-"}) {
    options_.picture = name;
    EXPECT_EQ(error_of([&] { run(); }),
              "cannot write '" + std::string(name) + "': the output is a PNG; name it .png");
  }
  EXPECT_EQ(out(), "");
}

TEST_F(Stability, Lists) {
  options_.list = true;
  EXPECT_EQ(run(), kExitFine);
  for (const spec::HardFamily& family : spec::hard_families())
    expect_contains(out(), "\n  " + std::string(family.name) + " ");
  expect_contains(out(), "\n  float32-plane ");
  options_.json = true;
  EXPECT_EQ(run(), kExitFine);
  ASSERT_EQ(json()["families"].size(), spec::hard_families().size());
  EXPECT_EQ(json()["families"][0]["reason"], spec::hard_families().front().reason);
  EXPECT_EQ(json()["arithmetics"].size(), 8u);
}

TEST_F(Stability, RefusesWrongUse) {
  const auto refused = [&](auto change) {
    options_ = {};
    change(options_);
    return error_of([&] { run(); });
  };
  expect_contains(refused([](StabilityOptions& o) {
                    o.families = {a_family(), "NOPE"};
                  }),
                  "--family: no hard family is called 'NOPE'; there are slivers ");
  expect_contains(refused([](StabilityOptions& o) { o.arithmetics = {"float16"}; }),
                  "--arithmetic: no arithmetic is called 'float16'; there are abrash56 abrash57 "
                  "dkit fixed1616 float32-dda float32-plane float64-dda exact");
  expect_contains(refused([](StabilityOptions& o) { o.cases = "0"; }),
                  "--cases: '0' is no number from 1 to");
  expect_contains(refused([](StabilityOptions& o) { o.seed = "-1"; }),
                  "--seed: '-1' is no number from 0 to");
}

TEST_F(Stability, CountsToATerminalOnly) {
  std::ostringstream text, progress;
  options_.arithmetics = {"exact"};
  EXPECT_EQ(run_stability(options_, spec::built_in(), {text, progress, true}), kExitFine);
  expect_contains(progress.str(), a_family() + " 0 of 2");
}

}  // namespace
}  // namespace selvage::cli::test
