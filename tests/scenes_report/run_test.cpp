// selvage_scenes on pictures so small that it takes a second.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/png.h"
#include "reports/scenes/plot_data.h"
#include "tests/temporary_folder.h"

namespace selvage::reports {
namespace {

using json = nlohmann::ordered_json;
namespace fs = std::filesystem;

[[nodiscard]] std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class ScenesRun : public testing::Test {
 protected:
  [[nodiscard]] int run(const std::string& arguments) const {
    fs::create_directories(out_);
    const std::string command = std::string(SELVAGE_SCENES) + " --output " + out_.string() + " " +
                                arguments + " >" + table_.string() + " 2>" + errors_.string();
    return WEXITSTATUS(std::system(command.c_str()));
  }

  [[nodiscard]] cli::Raster picture(const std::string& name) const {
    const std::string bytes = text_of(out_ / name);
    return cli::decode_png({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()});
  }

  void check_trial(const json& trial, uint64_t shown_px) const;

  const TemporaryFolder folder_;
  const fs::path out_ = folder_.path() / "out";
  const fs::path table_ = folder_.path() / "table", errors_ = folder_.path() / "errors";
};

void ScenesRun::check_trial(const json& trial, uint64_t shown_px) const {
  SCOPED_TRACE(trial.at("overlay"));
  EXPECT_EQ(trial.at("breaches"), 0) << trial.at("first_breach");
  const double measured = trial.at("largest_error_texel"), bound = trial.at("bound_texel");
  EXPECT_LE(trial.at("mean_error_texel"), measured);
  EXPECT_LE(measured, bound);
  EXPECT_LE(bound, trial.at("tolerance_texel"));
  if (trial.at("tolerance_texel") == 0) {
    EXPECT_EQ(trial.at("different_px"), 0);
    EXPECT_EQ(trial.at("wrong_texels"), 0);
  }
  uint64_t px = 0;
  for (const json& choice : trial.at("choices")) {
    px += choice.at("px").get<uint64_t>();
    EXPECT_GT(choice.at("faces"), 0);
  }
  EXPECT_EQ(px, shown_px);
  for (const char* key : {"ns_per_px", "textured_ns_per_px"}) {
    const json& ns = trial.at(key);
    EXPECT_GT(ns.at("lower_quartile"), 0);
    EXPECT_LE(ns.at("lower_quartile"), ns.at("median"));
    EXPECT_LE(ns.at("median"), ns.at("upper_quartile"));
  }
  const auto overlay = picture(trial.at("overlay"));
  EXPECT_EQ(overlay.width_px, 64);
  EXPECT_EQ(overlay.height_px, 48 + 6 + 24 * static_cast<int32_t>(trial.at("choices").size()));
}

TEST_F(ScenesRun, DrawsJudgesTimesAndTells) {
  ASSERT_EQ(run("--shipped " SELVAGE_SHIPPED " --size 64x48 --frames 3 --repetitions 2 --min-time "
                "0.0001"),
            0)
      << text_of(errors_);
  const json scenes = json::parse(text_of(out_ / "scenes.json"));
  EXPECT_EQ(scenes.at("repetitions"), 2);
  ASSERT_EQ(scenes.at("scenes").size(), 2u);
  for (const json& one : scenes["scenes"]) {
    SCOPED_TRACE(one.at("id"));
    ASSERT_EQ(one.at("trials").size(), 10u);
    for (const json& trial : one["trials"]) check_trial(trial, one.at("shown_px"));
    EXPECT_GT(one["trials"].back().at("largest_error_texel"), 0);
    EXPECT_EQ(picture(one.at("picture")).height_px, 48);
    const std::string film = text_of(out_ / one.at("animation").get<std::string>());
    const size_t control = film.find("acTL");
    ASSERT_NE(control, std::string::npos);
    EXPECT_EQ(film[control + 7], 3);  // frames: the last of four bytes
  }
  // A tolerance, its place, and three cells for each of four lines of the plot.
  const std::string cost = text_of(out_ / "scenes-cost.tolerance_cost.dat");
  EXPECT_EQ(std::count(cost.begin(), cost.end(), '\n'), 6);
  EXPECT_EQ(std::count(cost.begin(), cost.end(), '\t'), 6 * 13);
  EXPECT_NE(cost.find("\n1/16\t1\t"), std::string::npos) << cost;
  const std::string error = text_of(out_ / "scenes-error.tolerance_error.dat");
  EXPECT_EQ(std::count(error.begin(), error.end(), '\t'), 6 * 9);
}

TEST_F(ScenesRun, WrongUseIsNamed) {
  EXPECT_EQ(run("--shipped /there/is/none"), 2);
  EXPECT_NE(text_of(errors_).find("/there/is/none"), std::string::npos);
  EXPECT_EQ(run("--shipped " SELVAGE_SHIPPED " --size 9000x9"), 2);
  EXPECT_NE(text_of(errors_).find("4096"), std::string::npos);
  EXPECT_EQ(run("--shipped " SELVAGE_SHIPPED " --frames 0"), 2);
}

TEST(PlotData, LeavesOutCostWhereNothingWasTimed) {
  const json trial = {{"filter", "auto"},
                      {"tolerance", "1/4"},
                      {"largest_error_texel", 0.1},
                      {"mean_error_texel", 0},
                      {"textured_ns_per_px", nullptr}};
  const json scenes = {{"scenes", {{{"id", "one"}, {"trials", {trial}}}}}};
  const auto files = plot_data(scenes);
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files[0].second, "\t\tone, auto\t\n1/4\t0\t-1\t-7\n");
}

}  // namespace
}  // namespace selvage::reports
