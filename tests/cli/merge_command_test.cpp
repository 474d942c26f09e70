// Shards and their sum.
#include "cli/merge_command.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/corpus.h"
#include "cli/verify_command.h"
#include "support.h"
#include "wrong_subjects.h"

namespace selvage::cli::test {
namespace {

class Merge : public InDirectory {
 protected:
  // What `verify` prints about the subject as JSON.
  static std::string verified(const spec::Subject& subject, const std::string& shard,
                              const std::string& seed = "5", const std::string& profile = "exact",
                              const std::string& cases = "100", const std::string& hunt = "70") {
    VerifyOptions options;
    options.laws = {"COV", "MAP", "CLIP", "IDENTITY", "TOLERANCE"};
    if (profile != "exact") options.laws = {"COV", "MAP", "DDA"};
    options.cases = cases;
    options.hunt = hunt;
    options.seed = seed;
    options.shard = shard;
    options.profile = profile;
    options.json = true;
    std::ostringstream out, err;
    (void)run_verify(options, subject, {out, err});
    return out.str();
  }

  static std::vector<std::string> put_shards(const spec::Subject& subject, int count,
                                             const std::string& profile = "exact",
                                             const std::string& cases = "100",
                                             const std::string& hunt = "70") {
    std::vector<std::string> names;
    for (int i = count; i >= 1; --i) {  // in any order
      names.push_back(std::to_string(i) + ".json");
      put(names.back(), verified(subject, std::to_string(i) + "/" + std::to_string(count), "5",
                                 profile, cases, hunt));
    }
    return names;
  }

  static nlohmann::json without_times(const std::string& json) {
    nlohmann::json values = nlohmann::json::parse(json);
    for (auto& law : values["laws"]) {
      law.erase("time_ns");
      if (law.contains("violation")) law["violation"].erase("picture");
    }
    return values;
  }

  std::string merge(const std::vector<std::string>& files, int code) {
    std::ostringstream out, err;
    EXPECT_EQ(run_merge({.files = files, .junit = "out.xml", .json = true}, {out, err}), code);
    return out.str();
  }
};

using MergeAtLength = Merge;

TEST_F(MergeAtLength, GivesTheVerdictOfTheRunInOnePiece) {
  for (const int count : {1, 2, 3, 8}) {
    const auto right = put_shards(spec::built_in(), count);
    EXPECT_EQ(without_times(merge(right, kExitFine)),
              without_times(verified(spec::built_in(), "")));
    const auto wrong = put_shards(shifted_texture(1), count);
    EXPECT_EQ(without_times(merge(wrong, kExitLawFailed)),
              without_times(verified(shifted_texture(1), "")));
    const auto nothing = put_shards(blank(), count);
    EXPECT_EQ(without_times(merge(nothing, kExitLawFailed)), without_times(verified(blank(), "")));
  }
  expect_contains(get("out.xml"), "<testsuites");
}

// What no random case shows and the hunt does: of 8 cases none, here.
TEST_F(Merge, KeepsWhatTheHuntFound) {
  const spec::Subject wrong = far_shifted_texture();
  const auto shards = put_shards(wrong, 3, "exact", "8", "400");
  const nlohmann::json whole = without_times(merge(shards, kExitLawFailed));
  EXPECT_EQ(whole, without_times(verified(wrong, "", "5", "exact", "8", "400")));
  EXPECT_EQ(whole["laws"][1]["violation"]["found_by"], "hunt") << whole["laws"][1];
  EXPECT_GT(whole["laws"][1]["cases"], 8);
}

TEST_F(Merge, KeepsTheNearestMargin) {
  const auto shards = put_shards(spec::built_in(), 3, "abrash56");
  const nlohmann::json whole = without_times(merge(shards, kExitFine));
  EXPECT_EQ(whole, without_times(verified(spec::built_in(), "", "5", "abrash56")));
  const nlohmann::json& nearest = whole["laws"][1]["nearest"];
  EXPECT_GT(nearest["measured"], 0.0);
  EXPECT_LE(nearest["measured"], nearest["bound"]);
}

// Shards that fail on the same known violation may have drawn it, each, into a file of its own.
TEST_F(Merge, TellsTheSameInWhicheverOrderTheFilesCome) {
  auto files = put_shards(blank(), 3, "exact", "9", "0");
  for (const std::string& name : files) {
    auto values = nlohmann::json::parse(get(name));
    for (auto& law : values["laws"]) {
      if (!law.contains("violation")) continue;
      law["violation"]["found_by"] = "corpus";
      law["violation"]["case_number"] = 0;
      law["violation"]["picture"] = name;
      law["known"] = {{"tried", 1}, {"not_judged", {{"of " + name, 1}}}};
    }
    put(name, values.dump());
  }
  const auto first = nlohmann::json::parse(merge(files, kExitLawFailed));
  EXPECT_EQ(first["laws"][0]["violation"]["picture"], "1.json");
  std::ranges::sort(files);
  do {
    EXPECT_EQ(nlohmann::json::parse(merge(files, kExitLawFailed)), first);
  } while (std::ranges::next_permutation(files).found);
}

TEST_F(Merge, TellsOfWhichSubjectTheVerdictIs) {
  const auto shards = put_shards(spec::built_in(), 2, "abrash56", "10", "0");
  std::ostringstream out, err;
  EXPECT_EQ(run_merge({.files = shards, .junit = "", .json = false}, {out, err}), kExitFine);
  EXPECT_EQ(out.str().rfind("subject " + spec::built_in().name + ", profile abrash56\nseed 5\n", 0),
            0u)
      << out.str();
  spec::Subject inexact = spec::built_in();
  inexact.claims.accuracy_fx16 = SELVAGE_SUBTEXELS / 2;
  const auto within = put_shards(inexact, 2, "exact", "10", "0");
  out.str("");
  EXPECT_EQ(run_merge({.files = within, .junit = "", .json = false}, {out, err}), kExitFine);
  expect_contains(out.str(), ", profile exact, within 1/2 texel\nseed 5\n");
}

// Whichever began first, and whatever was known by then: no shard writes what another one reads.
TEST_F(Merge, TakesShardsThatShareACorpus) {
  const std::string verify =
      "'" SELVAGE_PROGRAM
      "' verify --profile dkit --law PART --law COV --seed 5 --cases 60 --corpus known --json ";
  const auto shard = [&](const std::string& i) {
    return verify + "--shard " + i + "/4 >" + i + ".json";
  };
  std::string all;
  for (const char* i : {"1", "2", "3", "4"}) all += shard(i) + " & ";
  ASSERT_EQ(std::system((all + "wait").c_str()), 0);
  EXPECT_FALSE(std::filesystem::exists("known"));
  const std::vector<std::string> files = {"1.json", "2.json", "3.json", "4.json"};
  const nlohmann::json whole = without_times(merge(files, kExitLawFailed));
  (void)std::system((verify + "--shard 1/1 >whole.json").c_str());
  EXPECT_EQ(whole, without_times(get("whole.json")));
  ASSERT_EQ(std::distance(std::filesystem::directory_iterator("known"), {}), 1);

  (void)std::system(shard("3").c_str());  // which knows the violation
  const nlohmann::json late = without_times(merge(files, kExitLawFailed));
  EXPECT_EQ(late["known_cases"], 1);
  EXPECT_EQ(late["laws"][0]["known"]["tried"], 1);
  EXPECT_EQ(late["laws"][0]["violation"]["found_by"], "corpus");
}

TEST_F(Merge, AddsWhatIsNewToACorpus) {
  const auto shards = put_shards(shifted_texture(1), 2);
  std::ostringstream out;
  const auto merge_into = [&](const char* corpus) {
    std::ostringstream err;
    return run_merge({.files = shards, .corpus = corpus, .junit = "", .json = true}, {out, err});
  };
  expect_contains(error_of([&] { (void)merge_into("nowhere/known"); }),
                  "there is no directory 'nowhere'");
  EXPECT_EQ(merge_into("known"), kExitLawFailed);
  const auto known = read_corpus("known");
  ASSERT_FALSE(known.empty());
  const nlohmann::json merged = nlohmann::json::parse(out.str());
  for (const auto& law : merged["laws"]) {
    if (!law.contains("violation")) continue;
    const std::string name = law["law"], found = law["violation"]["case"];
    const auto is_it = [&](const KnownCase& one) {
      return one.law == name && spec::to_hex(one.found) == found;
    };
    EXPECT_TRUE(std::ranges::any_of(known, is_it)) << name;
  }
}

// A law is not judged as long as one shard had no time for it, and a violation is one all the same.
TEST_F(Merge, TellsWhatAShardHadNoTimeFor) {
  const auto deny_time = [](const std::string& name) {
    auto values = nlohmann::json::parse(get(name));
    values["passed"] = false;
    values["laws"][0]["verdict"] = "not judged";
    values["laws"][0]["cases"] = values["laws"][0]["judged_px"] = 0;
    put(name, values.dump());
  };
  const auto right = put_shards(spec::built_in(), 2);
  deny_time("2.json");
  const auto whole = nlohmann::json::parse(merge(right, kExitNoTime));
  EXPECT_EQ(whole["passed"], false);
  EXPECT_EQ(whole["laws"][0]["verdict"], "not judged");
  EXPECT_GT(whole["laws"][0]["judged_px"], 0) << "by the other shard";
  EXPECT_EQ(whole["laws"][1]["verdict"], "holds");
  expect_contains(get("out.xml"), "<skipped message=\"not judged: the time was over\"/>");
  const auto wrong = put_shards(shifted_texture(1), 2);
  deny_time("2.json");
  (void)merge(wrong, kExitLawFailed);
}

TEST_F(Merge, RefusesACaseThatWasCutOff) {
  auto damaged = nlohmann::json::parse(verified(blank(), "1/1", "5", "exact", "4", "0"));
  for (const char* key : {"case", "shown_case"}) {
    nlohmann::json cut_off = damaged;
    auto& digits = cut_off["laws"][0]["violation"][key].get_ref<std::string&>();
    digits.resize(digits.size() - 2);
    put("damaged.json", cut_off.dump());
    expect_contains(error_of([&] { (void)merge({"damaged.json"}, 2); }),
                    "digits of a case are no whole one as verify prints it");
  }
}

TEST_F(Merge, RefusesWhatIsNotAllOfOneRun) {
  (void)put_shards(spec::built_in(), 2);
  const auto refused = [&](const std::vector<std::string>& files) {
    std::ostringstream out;
    return error_of([&] {
      (void)run_merge({.files = files, .junit = "", .json = false}, {out, out});
    });
  };
  expect_contains(refused({"1.json"}), "shard 2/2 is missing");
  expect_contains(refused({"1.json", "1.json"}), "shard 1/2 is there twice: '1.json' and '1.json'");
  put("seed.json", verified(spec::built_in(), "2/2", "6"));
  expect_contains(refused({"1.json", "seed.json"}),
                  "the seed is '5' in '1.json' and '6' in 'seed.json'");
  put("count.json", verified(spec::built_in(), "2/3"));
  expect_contains(refused({"1.json", "count.json"}), "the number of shards is '2'");
  put("subject.json", verified(blank(), "2/2"));
  expect_contains(refused({"1.json", "subject.json"}), "the subject is 'selvage ");
  put("profile.json", verified(spec::built_in(), "2/2", "5", "abrash56"));
  expect_contains(refused({"1.json", "profile.json"}),
                  "the profile is 'exact' in '1.json' and 'abrash56' in 'profile.json'");
  spec::Subject inexact = spec::built_in();
  inexact.claims.accuracy_fx16 = 64;
  put("accuracy.json", verified(inexact, "2/2"));
  expect_contains(refused({"1.json", "accuracy.json"}),
                  "the accuracy in 1/65536 texel is '0' in '1.json' and '64' in 'accuracy.json'");
  inexact.claims = {.coverage_accuracy_fx16 = 64};
  put("coverage.json", verified(inexact, "2/2"));
  expect_contains(refused({"1.json", "coverage.json"}),
                  "the accuracy of coverage in 1/65536 px is '0'");
  const auto change = [&](const char* key, const nlohmann::json& value) {
    auto values = nlohmann::json::parse(get("2.json"));
    values[key] = value;
    put("changed.json", values.dump());
  };
  change("not_exported", {{{"function", "selvage_prepare"}, {"law", "SAME"}}});
  expect_contains(refused({"changed.json", "1.json"}),
                  "the list of functions that are not exported is '' in '1.json' and "
                  "'selvage_prepare' in 'changed.json'");
  change("oracle_missing", true);
  expect_contains(refused({"1.json", "changed.json"}),
                  "whether ORACLE is missing is 'no' in '1.json' and 'yes' in 'changed.json'");
  EXPECT_EQ(refused({"none.json"}), "cannot read 'none.json': No such file or directory");
  put("text.json", std::string("no verdict"));
  expect_contains(refused({"text.json"}), "text.json:1: not JSON: ");
}

// What damaged files say of their shards must not be allocated by, wrap around or pass.
TEST_F(Merge, RefusesDamagedNumbers) {
  const auto whole =
      nlohmann::json::parse(verified(spec::built_in(), "1/2", "5", "exact", "4", "0"));
  const auto refused = [&](const char* path, const char* value) {
    nlohmann::json damaged = whole;
    damaged[nlohmann::json::json_pointer(path)] = nlohmann::json::parse(value);
    put("damaged.json", damaged.dump());
    return error_of([&] { (void)merge({"damaged.json"}, 2); });
  };
  const char *const index = "/shard/index", *const of = "/shard/of";
  expect_contains(refused(index, "0"), ": shard: there is no shard 0/2; 1/2 to 2/2 are");
  expect_contains(refused(index, "3"), ": shard: there is no shard 3/2; 1/2 to 2/2 are");
  expect_contains(refused(of, "0"), "there is no shard 1/0");
  for (const char* huge : {"20000000000", "1000000000000000000", "18446744073709551615"}) {
    expect_contains(refused(of, huge), "shard 2/" + std::string(huge) + " is missing");
  }
  for (const char* wrong : {"1.5", "-1", "18446744073709551616", "1e3", "\"1\"", "true"}) {
    for (const char* path : {index, of, "/cases", "/seed", "/laws/0/cases", "/laws/0/judged_px"}) {
      expect_contains(refused(path, wrong),
                      "a whole number from 0 to 18446744073709551615 is needed, not ");
    }
  }
  expect_contains(refused("/laws/0/time_ns", "9223372036854775808"),
                  "time_ns: a whole number from -9223372036854775808 to 9223372036854775807 is");
  for (const char* wrong : {"2147483648", "-2147483649", "0.5"}) {
    expect_contains(refused("/accuracy_fx16", wrong),
                    "a whole number from -2147483648 to 2147483647 is needed, not ");
  }
  const char* negative = R"({"measured": -1, "bound": 1})";
  expect_contains(refused("/laws/0/nearest", negative), "measured: no error is below 0");
  const char* without = R"({"measured": 0, "bound": 0})";
  expect_contains(refused("/laws/0/nearest", without), "bound: a bound is above 0");
  expect_contains(refused("/laws", "[]"), "it has no verdict of any law, and so shows nothing");
}

// One that has lost its violation is no law that holds.
TEST_F(Merge, RefusesWhatContradictsItself) {
  const auto right =
      nlohmann::json::parse(verified(spec::built_in(), "1/1", "5", "exact", "4", "0"));
  const auto wrong = nlohmann::json::parse(verified(blank(), "1/1", "5", "exact", "4", "0"));
  const auto refused = [&](nlohmann::json from, const char* path, const nlohmann::json& value) {
    const nlohmann::json::json_pointer at(path);
    if (value.is_null()) from[at.parent_pointer()].erase(at.back());
    if (!value.is_null()) from[at] = value;
    put("contradiction.json", from.dump());
    return error_of([&] { (void)merge({"contradiction.json"}, 2); });
  };
  expect_contains(refused(wrong, "/laws/0/violation", nullptr),
                  "it is 'violated', but what follows is of one that is 'holds'");
  expect_contains(refused(wrong, "/laws/0/verdict", "holds"),
                  "it is 'holds', but what follows is of one that is 'violated'");
  expect_contains(refused(right, "/laws/0/verdict", "fine\x1b"), "it is 'fine\xEF\xBF\xBD'");
  expect_contains(refused(right, "/laws/1", right["laws"][0]), "the law was told of before");
  expect_contains(refused(right, "/passed", false), "it is false, but the verdicts");
}

}  // namespace
}  // namespace selvage::cli::test
