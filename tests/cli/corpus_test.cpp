#include "cli/corpus.h"

#include <sys/stat.h>

#include <sstream>
#include <thread>

#include "support.h"

namespace selvage::cli::test {
namespace {

class Corpus : public InDirectory {
 protected:
  // Makes it, and returns what is told of that.
  static std::string made(const std::filesystem::path& directory) {
    std::ostringstream out, err;
    make_corpus(directory, {out, err});
    EXPECT_EQ(out.str(), "");
    return err.str();
  }
};

TEST_F(Corpus, IsMadeWhereItIsNot) {
  EXPECT_EQ(made("known"), "selvage: made the directory 'known'\n");
  EXPECT_EQ(made("known"), "");
  EXPECT_EQ(made("known/"), "");
  EXPECT_EQ(made("known/of_mine/"), "selvage: made the directory 'known/of_mine'\n");
  EXPECT_EQ(
      made(std::filesystem::current_path() / "other"),
      "selvage: made the directory '" + std::filesystem::current_path().string() + "/other'\n");
  EXPECT_TRUE(std::filesystem::is_directory("known/of_mine"));
}

// A mistyped path would be made, and hold no known violation.
TEST_F(Corpus, IsNotMadeWithWhatIsAboveIt) {
  EXPECT_EQ(error_of([] { (void)made("knwon/of_mine"); }),
            "--corpus: cannot make 'knwon/of_mine': there is no directory 'knwon'");
  put("file", std::string());
  expect_contains(error_of([] { (void)made("file"); }), "'file' is no directory");
  expect_contains(error_of([] { (void)made("file/known"); }), "there is no directory 'file'");
  expect_contains(error_of([] { (void)read_corpus("known"); }), "--corpus: cannot read 'known'");
  EXPECT_EQ(files(), std::vector<std::string>{"file"});
}

TEST_F(Corpus, IsReadAsItWasWritten) {
  std::filesystem::create_directory("known");
  EXPECT_TRUE(read_corpus("known").empty());
  spec::Case c;
  c.target_width_px = 7;
  write_to_corpus("known", {"MAP", c});
  write_to_corpus("known", {"MAP", c});
  write_to_corpus("known", {"COV", spec::Case{}});
  put("known/README", std::string("not a case"));
  const std::vector<KnownCase> known = read_corpus("known");
  ASSERT_EQ(known.size(), 2u) << "the same violation is the same file";
  EXPECT_EQ(known[0].law, "COV");
  EXPECT_EQ(known[1].law, "MAP");
  EXPECT_EQ(known[1].found, c);
}

TEST_F(Corpus, NamesFilesByLawAndCase) {
  spec::Case c;
  const std::string name = corpus_name("MAP", c);
  EXPECT_EQ(name.size(), std::string("MAP-0123456789abcdef.case").size());
  EXPECT_EQ(corpus_name("MAP", c), name);
  c.choice = 1;
  EXPECT_NE(corpus_name("MAP", c), name);
}

TEST_F(Corpus, NamesTheFileThatIsNoCase) {
  std::filesystem::create_directory("known");
  const std::string whole = spec::to_hex(spec::Case{});
  const std::string cut_off = "MAP " + whole.substr(0, whole.size() - 2);
  for (const std::string& text : {std::string(), std::string("MAP"), std::string("MAP 0"),
                                  "MAP " + whole + " 00", std::string("MAP xx"), cut_off}) {
    put("known/a.case", text);
    expect_contains(error_of([] { (void)read_corpus("known"); }), "'known/a.case' is no known");
  }
  put("known/a.case", "MOP " + whole);
  expect_contains(error_of([] { (void)read_corpus("known"); }),
                  "'known/a.case': no law is called 'MOP'");
}

// A pipe would be waited for.
TEST_F(Corpus, NamesWhatIsNoFile) {
  std::filesystem::create_directory("known");
  ASSERT_EQ(mkfifo("known/a.case", 0600), 0);
  expect_contains(error_of([] { (void)read_corpus("known"); }),
                  "'known/a.case' is no regular file");
  std::filesystem::remove("known/a.case");
  std::filesystem::create_directory("known/b.case");
  expect_contains(error_of([] { (void)read_corpus("known"); }),
                  "'known/b.case' is no regular file");
}

// Whoever reads while others write sees whole cases and no half ones.
TEST_F(Corpus, MayBeWrittenByManyAtOnce) {
  static constexpr uint32_t kCases = 20;
  std::filesystem::create_directory("known");
  const auto write = [] {
    for (uint32_t choice = 0; choice < kCases; ++choice) {
      spec::Case c;
      c.choice = choice;
      write_to_corpus("known", {"MAP", c});
      for (const KnownCase& known : read_corpus("known")) EXPECT_LT(known.found.choice, kCases);
    }
  };
  std::vector<std::thread> writers;
  for (int i = 0; i < 3; ++i) writers.emplace_back(write);
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(read_corpus("known").size(), kCases);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator("known"), {}), kCases)
      << "nothing else is left there";
}

}  // namespace
}  // namespace selvage::cli::test
