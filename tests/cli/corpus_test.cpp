#include "cli/corpus.h"

#include "support.h"

namespace selvage::cli::test {
namespace {

class Corpus : public InDirectory {};

TEST_F(Corpus, IsReadAsItWasWritten) {
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
  for (const char* text : {"", "MAP", "MAP 0", "MAP 00 00", "MAP xx"}) {
    put("known/a.case", std::string(text));
    expect_contains(error_of([] { (void)read_corpus("known"); }), "'known/a.case' is no known");
  }
  put("file", std::string());
  expect_contains(error_of([] { (void)read_corpus("file"); }), "'file' is no directory");
}

}  // namespace
}  // namespace selvage::cli::test
