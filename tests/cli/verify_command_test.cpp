#include "cli/verify_command.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/laws_command.h"
#include "cli/picture_file.h"
#include "spec/generate.h"
#include "spec/laws.h"
#include "spec/profiles.h"
#include "spec/promise.h"
#include "support.h"
#include "wrong_subjects.h"

namespace selvage::cli::test {
namespace {

using Names = std::vector<std::string>;

class Verify : public InDirectory {
 protected:
  Verify() {
    options_.cases = "30";
    options_.seed = "5";
  }

  int run(const spec::Subject& subject = spec::built_in()) {
    out_.str("");
    err_.str("");
    return run_verify(options_, subject, {out_, err_});
  }
  [[nodiscard]] std::string out() const { return out_.str(); }
  [[nodiscard]] std::string err() const { return err_.str(); }
  [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(out()); }

  // The text after `label` up to the end of its line.
  [[nodiscard]] std::string line_after(const std::string& label) const {
    const std::string text = out();
    const size_t start = text.find(label);
    if (start == std::string::npos) return {};
    const size_t from = start + label.size();
    return text.substr(from, text.find('\n', from) - from);
  }

  VerifyOptions options_;

 private:
  std::ostringstream out_, err_;
};

TEST_F(Verify, OfTheBuiltInMapperHolds) {
  options_.cases = "60";
  for (const spec::Profile& profile : spec::profiles()) {
    options_.profile = std::string(profile.name);
    EXPECT_EQ(run(), kExitFine) << out();
    int promised = 0;
    for (const spec::Law& law : spec::laws()) {
      const spec::Standing standing = spec::promise(profile.id, law.name).standing;
      const std::string name(law.name);
      if (standing == spec::Standing::kPromised) expect_contains(out(), "\n" + name + " ");
      if (standing == spec::Standing::kPromised) ++promised;
      if (standing == spec::Standing::kNotPromised) {
        expect_contains(out(), "\nnot promised: " + name + ": ");
        EXPECT_EQ(out().find("\n" + name + " "), std::string::npos);
      }
    }
    const std::string count = std::to_string(promised);
    expect_contains(out(), count + " of " + count + " laws hold.\n");
    expect_contains(out(), "seed 5\n");
    EXPECT_EQ(files(), Names{});
  }
}

TEST_F(Verify, HoldsAMapperToTheProfileThatIsAskedFor) {
  options_.laws = {"PART"};
  options_.profile = "dkit";
  EXPECT_EQ(run(), kExitLawFailed);
  expect_contains(out(), "PART       VIOLATED");
  expect_contains(out(), "dkit, ");
  options_.profile = "abrash56";
  EXPECT_EQ(run(), kExitFine);
  options_.profile = "abrash55";
  expect_contains(error_of([&] { run(); }),
                  "--profile: 'abrash55' is no profile; the profiles are exact abrash56");
}

TEST_F(Verify, ChecksTheLawsThatWereAskedForOnce) {
  options_.laws = {"CLIP", "map", "CLIP"};
  EXPECT_EQ(run(), kExitFine);
  expect_contains(out(), "2 of 2 laws hold.");
  EXPECT_EQ(out().find("COV"), std::string::npos);
  EXPECT_LT(out().find("CLIP"), out().find("MAP"));
}

TEST_F(Verify, OfAWrongMapperExplainsAndDraws) {
  options_.laws = {"COV", "MAP"};
  EXPECT_EQ(run(shifted_texture(1)), kExitLawFailed);
  expect_contains(out(), "1 of 2 laws hold, 1 violated.");
  expect_contains(out(), "MAP        VIOLATED");
  expect_contains(line_after("replay: "), "selvage verify --law MAP --case ");
  EXPECT_EQ(line_after("picture: "), "selvage-MAP.png (drawn | expected | difference)");
  EXPECT_EQ(files(), Names{"selvage-MAP.png"});
  EXPECT_GT(read_picture("selvage-MAP.png").width_px, 3);
}

TEST_F(Verify, FindsThePictureRed) {
  options_.laws = {"COV"};
  EXPECT_EQ(run(blank()), kExitLawFailed);
  const Raster picture = read_picture("selvage-COV.png");
  bool red = false;
  for (int32_t x = 2 * picture.width_px / 3; x < picture.width_px; ++x) {
    for (int32_t y = 0; y < picture.height_px; ++y) {
      red = red || picture.at(x, y) == Colour{255, 0, 0};
    }
  }
  EXPECT_TRUE(red);
}

TEST_F(Verify, ReplaysWhatItFound) {
  options_.laws = {"MAP"};
  options_.json = true;
  EXPECT_EQ(run(shifted_texture(1)), kExitLawFailed);
  const auto violation = json()["laws"][0]["violation"];
  options_ = {};
  options_.laws = {"MAP"};
  options_.case_hex = violation["case"];
  EXPECT_EQ(run(shifted_texture(1)), kExitLawFailed);
  expect_contains(out(), violation["what"].get<std::string>());
  expect_contains(out(), spec::print(*spec::from_hex(options_.case_hex)));
  EXPECT_EQ(line_after("replay: "), violation["replay"].get<std::string>());
  EXPECT_EQ(run(), kExitFine) << "the built-in mapper draws that case right";
}

TEST_F(Verify, ReplaysRawBytesAsWell) {
  const spec::Case c = spec::decode(std::vector<uint8_t>(90, 17));
  put("case.bin", spec::encode(c));
  options_ = {};
  options_.case_file = "case.bin";
  run();
  const std::string from_file = out().substr(0, out().find("law "));
  options_.case_file.clear();
  options_.case_hex = spec::to_hex(c);
  run();
  EXPECT_EQ(out().substr(0, out().find("law ")), from_file);
  expect_contains(from_file, spec::print(c));
}

TEST_F(Verify, OfACaseWithNothingToJudgeFailsAndSaysSo) {
  options_ = {};
  options_.laws = {"MAP"};
  options_.case_hex = spec::to_hex(spec::Case{});  // no vertices
  EXPECT_EQ(run(), kExitLawFailed);
  expect_contains(out(), "judged nothing");
}

TEST_F(Verify, WithTheSameSeedIsTheSame) {
  options_.json = true;
  const auto without_times = [&] {
    nlohmann::json values = json();
    for (auto& law : values["laws"]) law.erase("time_ns");
    return values;
  };
  options_.laws = {"MAP", "COV"};
  run(shifted_texture(1));
  const nlohmann::json first = without_times();
  run(shifted_texture(1));
  EXPECT_EQ(without_times(), first);
  EXPECT_EQ(first["seed"], 5);
}

TEST_F(Verify, PrintsTheFreshSeedItTook) {
  options_.seed.clear();
  options_.laws = {"IDENTITY"};
  options_.json = true;
  run();
  const uint64_t seed = json()["seed"];
  run();
  EXPECT_NE(json()["seed"], seed);
  options_.json = false;
  run();
  EXPECT_FALSE(line_after("seed ").empty());
}

TEST_F(Verify, ReportsInJson) {
  options_.json = true;
  options_.laws = {"COV", "MAP"};
  EXPECT_EQ(run(shifted_texture(1)), kExitLawFailed);
  EXPECT_EQ(json()["subject"], "shifted");
  EXPECT_EQ(json()["passed"], false);
  EXPECT_EQ(json()["laws"][0]["verdict"], "holds");
  EXPECT_EQ(json()["laws"][0]["cases"], 30);
  EXPECT_EQ(json()["laws"][1]["verdict"], "violated");
  EXPECT_EQ(json()["laws"][1]["violation"]["picture"], "selvage-MAP.png");
  EXPECT_EQ(err(), "");
}

TEST_F(Verify, NamesThePicturesAsAsked) {
  options_.picture = "seen.png";
  options_.laws = {"MAP", "IDENTITY"};
  EXPECT_EQ(run(shifted_texture(1)), kExitLawFailed);
  EXPECT_EQ(files(), (Names{"seen-IDENTITY.png", "seen.png"}));
}

TEST_F(Verify, RefusesAPictureItCannotWriteBeforeItStarts) {
  options_.picture = "nowhere/seen.png";
  expect_contains(error_of([&] { run(shifted_texture(1)); }), "there is no directory 'nowhere'");
  for (const char* name : {"seen.txt", "-"}) {
    options_.picture = name;
    EXPECT_EQ(error_of([&] { run(shifted_texture(1)); }),
              "cannot write '" + std::string(name) + "': the output is a PNG; name it .png");
  }
  EXPECT_EQ(out(), "");
}

TEST_F(Verify, KeepsTheVerdictWhereThePictureFails) {
  std::filesystem::create_directory("selvage-MAP.png");
  options_.laws = {"MAP"};
  EXPECT_EQ(run(shifted_texture(1)), kExitLawFailed);
  expect_contains(out(), "MAP        VIOLATED");
  expect_contains(err(), "selvage: no picture of the violation: cannot write 'selvage-MAP.png'");
}

TEST_F(Verify, RefusesWrongUse) {
  const auto refused = [&](auto change) {
    options_ = {};
    change(options_);
    return error_of([&] { run(); });
  };
  const std::string law = refused([](VerifyOptions& o) { o.laws = {"COV", "NOPE"}; });
  expect_contains(law, "--law: no law is called 'NOPE'; the laws are COV PART");
  for (const char* cases : {"0", "-1", "many", "1.5", "1000000001", "0x10"}) {
    expect_contains(refused([&](VerifyOptions& o) { o.cases = cases; }),
                    "--cases: '" + std::string(cases) + "' is no number from 1 to");
  }
  for (const char* seed : {"-1", "x", "18446744073709551616"}) {
    expect_contains(refused([&](VerifyOptions& o) { o.seed = seed; }),
                    "--seed: '" + std::string(seed) + "' is no number from 0 to");
  }
  for (const char* hex : {"0", "0g", "00 00"}) {
    expect_contains(refused([&](VerifyOptions& o) { o.case_hex = hex; }),
                    "--case: an even number of hexadecimal digits is needed");
  }
  expect_contains(refused([](VerifyOptions& o) { o.case_file = "none"; }), "cannot read 'none'");
}

// A line that was not copied whole would replay another case, which may well hold.
TEST_F(Verify, ReplaysAWholeCaseAlone) {
  std::string whole = spec::to_hex(spec::generate(7));
  const auto refused = [&](const std::string& hex) {
    options_ = {};
    options_.case_hex = hex;
    return error_of([&] { run(); });
  };
  for (const std::string& hex :
       {whole.substr(0, whole.size() - 2), whole + "00", std::string("00"), whole + whole}) {
    expect_contains(refused(hex), "--case: the " + std::to_string(hex.size()) +
                                      " digits are no whole case as verify prints it");
  }
  for (char& digit : whole) digit = static_cast<char>(std::toupper(digit));
  options_.case_hex = whole;
  options_.laws = {"TOTAL"};
  run();
  expect_contains(out(), spec::print(*spec::from_hex(whole)));
}

TEST_F(Verify, TakesTheLargestSeed) {
  options_.seed = "18446744073709551615";
  options_.laws = {"IDENTITY"};
  EXPECT_EQ(run(), kExitFine);
  expect_contains(out(), "seed 18446744073709551615\n");
}

TEST_F(Verify, CountsToATerminalOnly) {
  options_.laws = {"COV"};
  std::ostringstream text, progress;
  EXPECT_EQ(run_verify(options_, spec::built_in(), {text, progress, true}), kExitFine);
  expect_contains(progress.str(), "COV ");
  expect_contains(progress.str(), " of 30");
  run();
  EXPECT_EQ(err(), "");
}

TEST(Laws, AreListedWithTheirStatements) {
  std::ostringstream text, json_text, err;
  EXPECT_EQ(run_laws(false, {text, err}), kExitFine);
  EXPECT_EQ(run_laws(true, {json_text, err}), kExitFine);
  const auto values = nlohmann::json::parse(json_text.str());
  ASSERT_EQ(values.size(), spec::laws().size());
  for (size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(values[i]["law"], spec::laws()[i].name);
    EXPECT_EQ(values[i]["statement"], spec::laws()[i].statement);
    expect_contains(text.str(), std::string(spec::laws()[i].statement) + "\n");
    for (const spec::Profile& profile : spec::profiles()) {
      const spec::Promise promise = spec::promise(profile.id, spec::laws()[i].name);
      const auto& entry = values[i]["profiles"][std::string(profile.name)];
      EXPECT_EQ(entry["standing"] == "promised", promise.standing == spec::Standing::kPromised);
      if (promise.note.empty()) continue;
      EXPECT_EQ(entry["note"], promise.note);
      expect_contains(text.str(), std::string(promise.note) + "\n");
    }
  }
}

}  // namespace
}  // namespace selvage::cli::test
