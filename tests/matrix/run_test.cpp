// reports/matrix, run on libraries of which it is known what is wrong with them.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "tests/temporary_folder.h"

namespace selvage {
namespace {

using json = nlohmann::ordered_json;
namespace fs = std::filesystem;

[[nodiscard]] std::string library(const std::string& name) {
  return std::string(SELVAGE_SUBJECTS) + "/" + name + ".so ";
}

[[nodiscard]] std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

[[nodiscard]] const json* cell_of(const json& subject, const std::string& law) {
  for (const json& cell : subject.at("cells")) {
    if (cell.at("law") == law) return &cell;
  }
  return nullptr;
}

class MatrixRun : public testing::Test {
 protected:
  [[nodiscard]] int run(const std::string& arguments) const {
    const std::string command = std::string(SELVAGE_TOP) + "/reports/matrix --program " +
                                SELVAGE_PROGRAM + " --only --jobs 2 --cases 40 --seed 1 --output " +
                                out_.string() + " " + arguments + " 2>" + errors_.string();
    return WEXITSTATUS(std::system(command.c_str()));
  }

  const TemporaryFolder folder_;
  const fs::path out_ = folder_.path() / "out", errors_ = folder_.path() / "errors";
};

// One run for all: what each row and each cell says, and the files that it names.
TEST_F(MatrixRun, HasARowForEachSubjectAndAPageForEachViolation) {
  ASSERT_EQ(run(library("right") + library("crashes") + library("claims_little") +
                library("crashes_on_load")),
            0)
      << text_of(errors_);
  const json matrix = json::parse(text_of(out_ / "matrix.json"));
  EXPECT_EQ(matrix.at("cases"), 40);
  EXPECT_EQ(matrix.at("seed"), 1);
  ASSERT_EQ(matrix.at("subjects").size(), 4u);
  std::map<std::string, json> rows;
  for (const json& subject : matrix["subjects"]) rows[subject.at("id")] = subject;

  for (const json& cell : rows["right"].at("cells")) EXPECT_EQ(cell.at("verdict"), "holds") << cell;
  EXPECT_EQ(rows["right"]["cells"].size() + 1, matrix["laws"].size());  // but DDA, of others
  EXPECT_TRUE(rows["right"].at("passed"));
  const json* coverage = cell_of(rows["right"], "COV");
  ASSERT_NE(coverage, nullptr);
  EXPECT_EQ(coverage->at("cases"), 40 + 10);
  EXPECT_EQ(coverage->at("hunted").at("cases"), 10);
  EXPECT_GT(coverage->at("judged_px"), 0);

  EXPECT_EQ(cell_of(rows["claims_little"], "TOTAL")->at("verdict"), "not promised");
  EXPECT_NE(cell_of(rows["claims_little"], "TOTAL")->at("why"), "");
  EXPECT_NE(rows["crashes_on_load"].at("error").get<std::string>().find("loading it"),
            std::string::npos);

  int violated = 0;
  for (const json& cell : rows["crashes"].at("cells")) {
    if (cell.at("verdict") != "violated") continue;
    ++violated;
    const std::string page = text_of(out_ / cell.at("page").get<std::string>());
    for (const char* key : {"allowed", "drawn", "replay"})
      EXPECT_NE(cell.at("violation").at(key), "") << key;
    EXPECT_NE(page.find("selvage verify --subject"), std::string::npos);
    const auto drawn = cell["violation"]["drawn"].get<std::string>();
    EXPECT_NE(drawn.find("wrote through a null pointer"), std::string::npos) << drawn;
    EXPECT_NE(page.find(drawn), std::string::npos);
    EXPECT_FALSE(cell["violation"].contains("picture")) << "of what has shrunk to nothing";
  }
  EXPECT_GT(violated, 10);
}

// A law that no case of its own broke, and that the counterexample of another row does.
TEST_F(MatrixRun, TriesOnEveryRowWhatIsNewOnAnother) {
  ASSERT_EQ(run("--cases 20 --hunt 0 " + library("draws_nothing") + library("misses_dots") +
                library("right")),
            0)
      << text_of(errors_);
  const json first = json::parse(text_of(out_ / "matrix" / "misses_dots.json"));
  for (const json& law : first.at("laws")) {
    const bool is_broken = law.at("law") == "TOTAL" && law.at("verdict") != "holds";
    EXPECT_FALSE(is_broken) << "there is nothing left for the second pass";
  }
  const json matrix = json::parse(text_of(out_ / "matrix.json"));
  const json* coverage = cell_of(matrix.at("subjects")[0], "COV");
  EXPECT_TRUE(
      fs::exists(out_ / "matrix" / coverage->at("violation").at("picture").get<fs::path>()));
  const json& misses = matrix.at("subjects")[1];
  const json* total = cell_of(misses, "TOTAL");
  ASSERT_EQ(total->at("verdict"), "violated");
  EXPECT_EQ(total->at("violation").at("found_by"), "corpus");
  EXPECT_TRUE(fs::exists(out_ / total->at("page").get<std::string>()));
  const json& right = matrix["subjects"][2];
  EXPECT_EQ(cell_of(right, "TOTAL")->at("verdict"), "holds");
  EXPECT_TRUE(right.at("passed"));
  EXPECT_TRUE(fs::exists(out_ / "matrix" / "right.again.json"));
}

TEST_F(MatrixRun, WrongUseIsNamed) {
  EXPECT_EQ(run("--hunt many"), 2);
  EXPECT_EQ(run("--cases 0"), 2);
  EXPECT_EQ(run("./there_is_none.so"), 2);
  EXPECT_NE(text_of(errors_).find("there_is_none"), std::string::npos);
}

}  // namespace
}  // namespace selvage
