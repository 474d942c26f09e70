// `selvage bench --near-ties`: what it takes and prints. Nothing here depends on times.
#include "cli/bench_near_ties.h"

#include "bench_run.h"
#include "cli/command_line.h"
#include "reports/bench/kernels.h"

namespace selvage::cli::test {
namespace {

class NearTies : public Bench {
 protected:
  NearTies() {
    options_.near_ties = "12";
    options_.seed = "5";
  }
};

TEST_F(NearTies, PrintATableOfTheWorst) {
  EXPECT_EQ(run(), kExitFine) << err();
  EXPECT_EQ(err(), "");
  expect_contains(out(), "12 maps from seed 5 on, kernel fastest: ");
  expect_contains(out(), "One again: selvage bench --near-ties 1 --seed SEED");
  std::istringstream lines{out()};
  int maps = 0;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 100u) << line;
    maps += line.find(" px") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(maps, static_cast<int>(reports::NearTieSearch::kWorst));
}

TEST_F(NearTies, AreReportedInJsonAndToAFile) {
  options_.json = true;
  options_.output = "ties.json";
  EXPECT_EQ(run(), kExitFine) << err();
  const nlohmann::json values = json();
  EXPECT_EQ(get("ties.json"), out());
  EXPECT_TRUE(values["machine"]["cpu"].is_string());
  EXPECT_EQ(values["seed"], 5);
  EXPECT_EQ(values["maps"], 12);
  EXPECT_EQ(values["most_times_ordinary"], reports::kMostTimesOrdinary);
  ASSERT_EQ(values["searches"].size(), 1u);
  const nlohmann::json& search = values["searches"][0];
  EXPECT_EQ(search["kernel"], "fastest");
  ASSERT_EQ(search["worst"].size(), reports::NearTieSearch::kWorst);
  const nlohmann::json& worst = search["worst"][0];
  EXPECT_DOUBLE_EQ(worst["ratio"].get<double>(),
                   worst["hard_ns"].get<double>() / worst["ordinary_ns"].get<double>());
  EXPECT_TRUE(worst["map"].is_string());
}

TEST_F(NearTies, AreSearchedByEachKernel) {
  options_.kernels = options_.json = true;
  options_.near_ties = "1";
  EXPECT_EQ(run(), kExitFine) << err();
  const nlohmann::json values = json();
  const std::vector<selvage_kernel> kernels = reports::kernels_here();
  ASSERT_EQ(values["searches"].size(), kernels.size());
  for (size_t i = 0; i < kernels.size(); ++i) {
    EXPECT_EQ(values["searches"][i]["kernel"], reports::kernel_name(kernels[i]));
    EXPECT_EQ(values["searches"][i]["worst"][0]["seed"], 5);
  }
}

TEST_F(NearTies, WantANumberOfMaps) {
  for (const char* wrong : {"0", "-3", "many", "1.5"}) {
    options_.near_ties = wrong;
    expect_contains(error_of([&] { static_cast<void>(run()); }),
                    "--near-ties: '" + std::string(wrong) + "' is no number");
  }
}

}  // namespace
}  // namespace selvage::cli::test
