// `selvage bench --compare`: what a baseline is, and what is told against one.
#include "cli/bench_comparison.h"
#include "bench_run.h"

namespace selvage::cli::test {
namespace {

TEST_F(Bench, ComparesWithWhatItWroteWholeOrBrief) {
  for (const bool brief : {false, true}) {
    options_.brief = brief;
    options_.json = false;
    options_.output = "before.json";
    options_.compare.clear();
    ASSERT_EQ(run(), kExitFine);
    options_.output.clear();
    options_.compare = "before.json";
    ASSERT_EQ(run(), kExitFine) << err();
    expect_contains(out(), "Against before.json (");
    expect_contains(out(), "time now / time then; below 1 is faster.");
    expect_contains(out(), "Geometric mean of all items:");
    EXPECT_EQ(out().find("another machine"), std::string::npos);
    EXPECT_EQ(out().find("were padded by"), std::string::npos);
    options_.brief = false;
    options_.json = true;
    ASSERT_EQ(run(), kExitFine);
    const nlohmann::json comparison = json()["comparison"];
    EXPECT_EQ(comparison["baseline"], "before.json");
    EXPECT_EQ(comparison["new"], 0);
    EXPECT_EQ(comparison["padding_px"], reports::kPadding_px);
    ASSERT_EQ(comparison["times"].size(), 4u);
    const nlohmann::json& time = comparison["times"][0];
    EXPECT_EQ(time["item"], "W1");
    EXPECT_EQ(time["subject"], "exact");
    EXPECT_DOUBLE_EQ(time["ratio"], time["now_ns"].get<double>() / time["then_ns"].get<double>());
  }
}

TEST_F(Bench, TellsWhatTheBaselineLacks) {
  put("other.json",
      R"({"machine": {"cpu": "an abacus"}, "medians_ns_per_px": {"W9": {"exact": 1}}})");
  options_.compare = "other.json";
  EXPECT_EQ(run(), kExitFine);
  expect_contains(out(), "It was measured on another machine: an abacus; this one is ");
  expect_contains(out(), "4 measurements are new: it has no time of them.");
  expect_contains(out(), "It has no time of what was measured here.");
}

TEST_F(Bench, TellsOfABaselineWhoseTargetsWerePaddedOtherwise) {
  options_.filter = "^W1/fill$";
  options_.compare = "other.json";
  const std::string told = "It was measured on targets whose rows were padded by ";
  put("other.json",
      R"({"machine": {}, "padding_px": 4, "medians_ns_per_px": {"W1": {"fill": 1}}})");
  EXPECT_EQ(run(), kExitFine);
  expect_contains(out(), told + "4 px, this run by 16 px, which changes times.");
  options_.padding = "4";
  EXPECT_EQ(run(), kExitFine);
  EXPECT_EQ(out().find(told), std::string::npos);
}

TEST_F(Bench, TakesABaselineThatSaysNothingOfPaddingAsOneWithout) {
  put("old.json", R"({"machine": {}, "medians_ns_per_px": {"W1": {"fill": 1}}})");
  options_.filter = "^W1/fill$";
  options_.compare = "old.json";
  EXPECT_EQ(run(), kExitFine);
  expect_contains(out(), "rows were padded by 0 px, this run by 16 px");
  options_.padding = "0";
  EXPECT_EQ(run(), kExitFine);
  EXPECT_EQ(out().find("were padded by"), std::string::npos);
  options_.json = true;
  EXPECT_EQ(run(), kExitFine);
  EXPECT_EQ(json()["comparison"]["padding_px"], 0);
}

TEST_F(Bench, ReadsTheRatiosOfAKnownBaseline) {
  const Baseline baseline = parse_baseline("b", R"({"machine": {"cpu": "c", "date": "d"},
      "workloads": [{"id": "W1", "results": [{"id": "exact", "ns_per_px": {"median": 2.5}},
                                             {"id": "dkit", "refusal": "no"}]}],
      "curves": [{"points": [{"id": "scale=2", "results":
                              [{"id": "fill", "ns_per_px": {"median": 0.5}}]}]}]})");
  EXPECT_EQ(baseline.ns.at("W1").at("exact"), 2.5);
  EXPECT_EQ(baseline.ns.at("W1").count("dkit"), 0u);
  EXPECT_EQ(baseline.ns.at("scale=2").at("fill"), 0.5);
  EXPECT_EQ(baseline.compiler, "unknown");
  TimeComparison comparison{baseline, {"c", 0}, {{"W1", "exact", 5, 2.5}}, 0};
  const std::string table = comparison_table(comparison);
  expect_contains(table, "\nexact               2.00\n");
  expect_contains(table, "\n  exact 2.00\n");
}

TEST_F(Bench, RefusesWhatIsNoBaseline) {
  const auto refused = [&](const std::string& text) {
    put("b.json", text);
    options_.compare = "b.json";
    return error_of([&] { run(); });
  };
  expect_contains(refused("{"), "b.json: not JSON: ");
  expect_contains(refused("[]"), "b.json: not the JSON of `selvage bench`: ");
  expect_contains(refused(R"({"machine": {}})"), "b.json: not the JSON of `selvage bench`: ");
  expect_contains(refused(R"({"machine": {}, "padding_px": "some", "medians_ns_per_px": {}})"),
                  "b.json: not the JSON of `selvage bench`: ");
  expect_contains(refused(R"({"machine": {}, "medians_ns_per_px": {"W1": {"exact": "fast"}}})"),
                  "b.json: the median of W1/exact is no time in ns");
  expect_contains(refused(R"({"machine": {}, "medians_ns_per_px": {"W1": {"exact": 0}}})"),
                  "b.json: the median of W1/exact is no time in ns");
  options_.compare = "nowhere.json";
  expect_contains(error_of([&] { run(); }), "nowhere.json");
}

TEST_F(Bench, IsNeverTooSlow) {
  put("fast.json", R"({"machine": {}, "medians_ns_per_px": {"W1": {"exact": 1e-9}}})");
  options_.compare = "fast.json";
  EXPECT_EQ(run(), kExitFine);
}

}  // namespace
}  // namespace selvage::cli::test
