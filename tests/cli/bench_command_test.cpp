// `selvage bench`: what it takes, what it prints, what it compares. Nothing here depends on how
// long anything took.
#include "cli/bench_command.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "../bench/support.h"
#include "cli/bench_report.h"
#include "cli/command_line.h"
#include "support.h"

namespace selvage::cli::test {
namespace {

using reports::test::box_subject;
using reports::test::rectangle;
using reports::test::small_workload;
using Names = std::vector<std::string>;

class Bench : public InDirectory {
 protected:
  Bench() {
    options_.rows = "2";
    options_.repetitions = "3";
    options_.min_time = "0.001";
    options_.filter = "^W1/(exact|fixed1616|fill|memcpy)$";
  }

  int run() {
    out_.str("");
    err_.str("");
    return run_bench(options_, {out_, err_});
  }
  int run(const reports::Plan& plan) {
    out_.str("");
    err_.str("");
    return run_plan(plan, options_, {out_, err_});
  }
  [[nodiscard]] std::string out() const { return out_.str(); }
  [[nodiscard]] std::string err() const { return err_.str(); }
  [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(out()); }

  BenchOptions options_;

 private:
  std::ostringstream out_, err_;
};

TEST_F(Bench, PrintsATableOfAHundredColumns) {
  options_.filter =
      "^(W1|W3-20000|A1|A1-ordinary|scale=2|scale=16)/(exact|fixed1616|fill|abrash56)$";
  options_.curves = true;
  EXPECT_EQ(run(), kExitFine) << err();
  EXPECT_EQ(err(), "");
  expect_contains(out(), "W1: rotated quad, 256 x 256. 1 polygon, 524287 pixels covered, 2048 ");
  expect_contains(out(), "\nexact ");
  expect_contains(out(), "\n  A1 exact: ");
  expect_contains(out(), " times A1-ordinary\n");
  expect_contains(out(), "Cost against scale: ");
  expect_contains(out(), "abrash56, abrash57 and dkit");
  std::istringstream lines{out()};
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
  EXPECT_EQ(files(), Names{});
}

TEST_F(Bench, PrintsRefusals) {
  options_.filter = "^W4/(fixed1616|fill)$";
  EXPECT_EQ(run(), kExitFine);
  expect_contains(out(), "\nfixed1616    not measured: it knows no perspective\n");
}

TEST_F(Bench, ReportsInJson) {
  options_.json = true;
  EXPECT_EQ(run(), kExitFine);
  const nlohmann::json values = json();
  for (const char* key : {"cpu", "cpu_simd", "compiler", "flags_mapper", "date", "selvage"})
    EXPECT_TRUE(values["machine"][key].is_string()) << key;
  EXPECT_EQ(values["seed"], 1);
  EXPECT_EQ(values["rows"], 2);
  EXPECT_EQ(values["repetitions"], 3);
  EXPECT_EQ(values["min_time_s"], 0.001);
  EXPECT_EQ(values["filter"], options_.filter);
  EXPECT_EQ(values["comparison"], nullptr);
  EXPECT_EQ(values["curves"].size(), 0u);
  ASSERT_EQ(values["subjects"].size(), 4u);
  EXPECT_EQ(values["subjects"][0]["group"], "ours");
  ASSERT_EQ(values["workloads"].size(), 1u);
  const nlohmann::json& work = values["workloads"][0];
  EXPECT_EQ(work["id"], "W1");
  EXPECT_EQ(work["ordinary"], nullptr);
  EXPECT_EQ(work["covered_px"], 524287);
  ASSERT_EQ(work["results"].size(), 4u);
  const nlohmann::json& exact = work["results"][0];
  EXPECT_EQ(exact["id"], "exact");
  EXPECT_EQ(exact["ratio_to_exact"], 1.0);
  for (const char* key : {"wrong_texels", "missing_px", "extra_px", "largest_texel", "mean_texel"})
    EXPECT_EQ(exact[key], 0) << key;
  EXPECT_EQ(exact["double_px"], nullptr) << "one polygon";
  EXPECT_EQ(exact["judged_px"], 2048);
  const nlohmann::json& time = exact["ns_per_px"];
  EXPECT_GT(time["median"], 0);
  EXPECT_LE(time["lower_quartile"], time["median"]);
  EXPECT_GE(time["upper_quartile"], time["median"]);
  const nlohmann::json& copy = work["results"][2];
  EXPECT_EQ(copy["id"], "memcpy");
  EXPECT_EQ(copy["missing_px"], nullptr);
  EXPECT_EQ(work["results"][3]["ratio_to_fill"], 1.0);
  EXPECT_EQ(work["results"][3]["wrong_texels"], nullptr);
}

TEST_F(Bench, ReportsFilteredColoursInLevels) {
  options_.filter = "^W[15]/exact$";
  EXPECT_EQ(run(), kExitFine) << err();
  expect_contains(out(), "Filtered: wrong is a colour whose worst channel is off by more than 1");
  options_.json = true;
  EXPECT_EQ(run(), kExitFine) << err();
  const nlohmann::json values = json();
  ASSERT_EQ(values["workloads"].size(), 2u);
  for (const nlohmann::json& work : values["workloads"]) {
    const bool filtered = work["filter"] == "bilinear";
    EXPECT_EQ(filtered, work["id"] == "W5");
    const nlohmann::json& exact = work["results"][0];
    const nlohmann::json none, zero = 0;
    for (const char* key : {"wrong_colours", "unequal_colours", "largest_level", "mean_level"})
      EXPECT_EQ(exact[key], filtered ? zero : none) << key;
    for (const char* key : {"wrong_texels", "largest_texel", "mean_texel"})
      EXPECT_EQ(exact[key], filtered ? none : zero) << key;
  }
}

TEST_F(Bench, ReportsAdversarialItemsByTheirTwins) {
  options_.filter = "^A1.*/fill$";
  options_.json = true;
  EXPECT_EQ(run(), kExitFine);
  const nlohmann::json values = json();
  ASSERT_EQ(values["workloads"].size(), 2u);
  EXPECT_EQ(values["workloads"][1]["ordinary"], "A1-ordinary");
  EXPECT_FALSE(values["workloads"][0]["results"][0].contains("ratio_to_ordinary"));
  EXPECT_TRUE(values["workloads"][1]["results"][0]["ratio_to_ordinary"].is_number());
  EXPECT_EQ(values["workloads"][1]["results"][0]["ratio_to_exact"], nullptr) << "not measured";
}

TEST_F(Bench, WritesAFileBesideItsTables) {
  options_.output = "bench.json";
  EXPECT_EQ(run(), kExitFine);
  expect_contains(out(), "W1: rotated quad");
  EXPECT_EQ(files(), Names{"bench.json"});
  EXPECT_EQ(nlohmann::json::parse(get("bench.json"))["workloads"][0]["id"], "W1");
}

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
    options_.brief = false;
    options_.json = true;
    ASSERT_EQ(run(), kExitFine);
    const nlohmann::json comparison = json()["comparison"];
    EXPECT_EQ(comparison["baseline"], "before.json");
    EXPECT_EQ(comparison["new"], 0);
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
  Comparison comparison{baseline, "c", {{"W1", "exact", 5, 2.5}}, 0};
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
  expect_contains(refused(R"({"machine": {}, "medians_ns_per_px": {"W1": {"exact": "fast"}}})"),
                  "b.json: the median of W1/exact is no time in ns");
  expect_contains(refused(R"({"machine": {}, "medians_ns_per_px": {"W1": {"exact": 0}}})"),
                  "b.json: the median of W1/exact is no time in ns");
  options_.compare = "nowhere.json";
  expect_contains(error_of([&] { run(); }), "nowhere.json");
}

TEST_F(Bench, ExitsWithOneWhereAReferenceErrs) {
  reports::Subject wrong = box_subject("mine", 0, 1);
  wrong.reference = true;
  const auto plan = reports::test::plan_of(small_workload({rectangle(2, 3, 10, 12)}), {wrong});
  options_.output = "bench.json";
  EXPECT_EQ(run(plan), kExitLawFailed);
  EXPECT_EQ(out(), "");
  expect_contains(err(), "selvage: small: 'mine' is not what it must be");
  expect_contains(err(), "Nothing was timed.");
  EXPECT_EQ(files(), Names{}) << "no output of a run that failed";
}

TEST_F(Bench, IsNeverTooSlow) {
  put("fast.json", R"({"machine": {}, "medians_ns_per_px": {"W1": {"exact": 1e-9}}})");
  options_.compare = "fast.json";
  EXPECT_EQ(run(), kExitFine);
}

TEST_F(Bench, Lists) {
  options_ = {};
  options_.list = true;
  options_.curves = true;
  EXPECT_EQ(run(), kExitFine);
  for (const char* name : {"W1 ", "W3-20000 ", "A4 ", "polygon-size=X ", "tol-1/256 ", "memcpy "})
    expect_contains(out(), std::string("\n  ") + name);
}

TEST_F(Bench, RefusesWrongUse) {
  const auto refused = [&](auto change) {
    options_ = {};
    change(options_);
    return error_of([&] { run(); });
  };
  expect_contains(refused([](BenchOptions& o) { o.seed = "-1"; }), "--seed: '-1' is no number");
  expect_contains(refused([](BenchOptions& o) { o.rows = "0"; }),
                  "--rows: '0' is no number from 1 to 4096");
  expect_contains(refused([](BenchOptions& o) { o.repetitions = "2"; }),
                  "--repetitions: '2' is no number from 3 to 1000");
  for (const char* time : {"0", "11", "long", "nan"})
    expect_contains(refused([&](BenchOptions& o) { o.min_time = time; }),
                    std::string("--min-time: '") + time + "' is no time from 0.001 to 10 s");
  expect_contains(refused([](BenchOptions& o) { o.filter = "("; }),
                  "--filter: '(' is no regular expression (ECMAScript): ");
  expect_contains(refused([](BenchOptions& o) { o.filter = "^W9/"; }),
                  "--filter: '^W9/' is found in no ITEM/SUBJECT; `selvage bench --list` tells");
  expect_contains(refused([](BenchOptions& o) {
                    o.filter = "^W1/fill$";
                    o.output = "nowhere/bench.json";
                  }),
                  "there is no directory 'nowhere'");
}

TEST_F(Bench, CountsToATerminalOnly) {
  std::ostringstream text, progress;
  options_.filter = "^W1/fill$";
  EXPECT_EQ(run_bench(options_, {text, progress, true}), kExitFine);
  expect_contains(progress.str(), "checking answers: row 1 of 2");
}

TEST_F(Bench, IsACommandWithHelp) {
  std::ostringstream text, errors;
  EXPECT_EQ(run_program({"bench", "--help"}, spec::built_in(), {text, errors}), kExitFine);
  for (const char* part : {"Examples:", "Exit codes:", "--filter", "--compare", "--curves"})
    expect_contains(text.str(), part);
}

TEST_F(Bench, RunsFromTheCommandLine) {
  std::ostringstream text, errors;
  EXPECT_EQ(run_program({"bench", "--filter", "^W1/fill$", "--rows", "2", "--repetitions", "3",
                         "--min-time", "0.001", "--brief", "--json"},
                        spec::built_in(), {text, errors}),
            kExitFine);
  const auto values = nlohmann::json::parse(text.str());
  EXPECT_TRUE(values["medians_ns_per_px"]["W1"]["fill"].is_number());
  EXPECT_EQ(values.count("workloads"), 0u);
}

}  // namespace
}  // namespace selvage::cli::test
