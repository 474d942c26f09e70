// `selvage bench`: what it takes, what it prints. Nothing here depends on how long anything took.
#include <map>

#include "../bench/support.h"
#include "bench_run.h"
#include "cli/command_line.h"

namespace selvage::cli::test {
namespace {

using reports::test::box_subject;
using reports::test::rectangle;
using reports::test::small_workload;
using Names = std::vector<std::string>;

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
  for (const char* key : {"cpu", "cpu_simd", "compiler", "flags_mapper", "date", "selvage",
                          "highway", "threads", "benchmark"})
    EXPECT_TRUE(values["machine"][key].is_string()) << key;
  EXPECT_EQ(values["seed"], 1);
  EXPECT_EQ(values["rows"], 2);
  EXPECT_EQ(values["repetitions"], 3);
  EXPECT_EQ(values["min_time_s"], 0.001);
  EXPECT_EQ(values["padding_px"], reports::kPadding_px);
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
  for (const char* key : {"wrong_texels", "missing_px", "extra_px", "extra_in_padding_px",
                          "largest_texel", "mean_texel"})
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
  options_.filter = "^W[157]/exact$";
  EXPECT_EQ(run(), kExitFine) << err();
  expect_contains(out(), "Filtered: wrong is a colour whose worst channel is off by more than 1");
  options_.json = true;
  EXPECT_EQ(run(), kExitFine) << err();
  const nlohmann::json values = json();
  ASSERT_EQ(values["workloads"].size(), 3u);
  const std::map<std::string, std::string> filters{
      {"W1", "nearest"}, {"W5", "bilinear"}, {"W7", "area"}};
  for (const nlohmann::json& work : values["workloads"]) {
    EXPECT_EQ(work["filter"], filters.at(work["id"]));
    const bool filtered = work["filter"] != "nearest";
    const nlohmann::json& exact = work["results"][0];
    const nlohmann::json none, zero = 0;
    for (const char* key : {"wrong_colours", "unequal_colours", "largest_level", "mean_level"})
      EXPECT_EQ(exact[key], filtered ? zero : none) << key;
    for (const char* key : {"wrong_texels", "largest_texel", "mean_texel"})
      EXPECT_EQ(exact[key], filtered ? none : zero) << key;
  }
}

TEST_F(Bench, ReportsAdversarialItemsByTheirTwins) {
  options_.filter = "^A1(-ordinary)?/fill$";
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

// Tells the pitch that it drew at.
[[nodiscard]] reports::Subject pitch_subject(ptrdiff_t& pitch) {
  reports::Subject subject = box_subject("mine", 0, 0);
  subject.prepare = [&pitch, draw = subject.prepare](const reports::Workload& load,
                                                     const reports::Texture& texture,
                                                     reports::Target& target) {
    pitch = target.image().pitch;
    return draw(load, texture, target);
  };
  return subject;
}

TEST_F(Bench, PadsTheRowsOfTargetsAsToldAndSaysSo) {
  ptrdiff_t pitch = 0;
  const auto plan =
      reports::test::plan_of(small_workload({rectangle(2, 3, 10, 12)}), {pitch_subject(pitch)});
  EXPECT_EQ(run(plan), kExitFine);
  EXPECT_EQ(pitch, (32 + 16) * 4);
  expect_contains(out(), "Behind each row of a target: 16 px of padding (--padding);");
  for (const int32_t padding_px : {0, 1, 1024}) {
    options_.padding = std::to_string(padding_px);
    for (const bool brief : {false, true}) {
      options_.json = true;
      options_.brief = brief;
      EXPECT_EQ(run(plan), kExitFine);
      EXPECT_EQ(pitch, (32 + padding_px) * 4);
      EXPECT_EQ(json()["padding_px"], padding_px);
    }
  }
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
  for (const char* padding : {"-1", "1025", "a line", ""})
    expect_contains(refused([&](BenchOptions& o) {
                      o.padding = padding;
                      o.list = true;  // nothing is measured, were it taken
                    }),
                    std::string("--padding: '") + padding + "' is no number from 0 to 1024");
  for (const char* time : {"0", "11", "long", "nan"})
    expect_contains(refused([&](BenchOptions& o) { o.min_time = time; }),
                    std::string("--min-time: '") + time + "' is no time from 0.001 to 10 s");
  expect_contains(refused([](BenchOptions& o) { o.filter = "("; }),
                  "--filter: '(' is no regular expression (ECMAScript): ");
  expect_contains(refused([](BenchOptions& o) { o.filter = "^W99/"; }),
                  "--filter: '^W99/' is found in no ITEM/SUBJECT; `selvage bench --list` tells");
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
  for (const char* part :
       {"Examples:", "Exit codes:", "--filter", "--compare", "--curves", "--padding"})
    expect_contains(text.str(), part);
}

TEST_F(Bench, RunsFromTheCommandLine) {
  std::ostringstream text, errors;
  EXPECT_EQ(run_program({"bench", "--filter", "^W1/fill$", "--rows", "2", "--repetitions", "3",
                         "--min-time", "0.001", "--padding", "0", "--brief", "--json"},
                        spec::built_in(), {text, errors}),
            kExitFine);
  const auto values = nlohmann::json::parse(text.str());
  EXPECT_TRUE(values["medians_ns_per_px"]["W1"]["fill"].is_number());
  EXPECT_EQ(values["padding_px"], 0);
  EXPECT_EQ(values.count("workloads"), 0u);
}

}  // namespace
}  // namespace selvage::cli::test
