#include "testbed/printable.h"

#include <gtest/gtest.h>

namespace selvage::testbed::test {
namespace {

constexpr const char* kTwo = "\xEF\xBF\xBD\xEF\xBF\xBD";

TEST(Printable, KeepsWhatIsValid) {
  for (const char* text : {"", "a mapper <1>", "\xC3\xA4", "\xE2\x82\xAC", "\xF0\x9F\x98\x80",
                           "\xC2\xA0", "\xEF\xBF\xBD", "\xF4\x8F\xBF\xBF"}) {
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Printable, ReplacesEachByteThatIsNoUtf8) {
  EXPECT_EQ(printable("\xFF\xFE"), kTwo);
  EXPECT_EQ(printable("\x80\x80"), kTwo);
  EXPECT_EQ(printable("\xC0\x80"), kTwo) << "a longer form than is needed";
  EXPECT_EQ(printable("\xE2\x82"), kTwo) << "cut within a character";
  EXPECT_EQ(printable("\xE2\x82z"), std::string(kTwo) + "z");
  EXPECT_EQ(printable("\xED\xA0\x80"), kTwo + std::string(kReplacement)) << "a surrogate";
  EXPECT_EQ(printable("\xF4\x90\x80\x80"), std::string(kTwo) + kTwo) << "beyond U+10FFFF";
}

TEST(Printable, ReplacesWhatTerminalsObeyAndXmlRefuses) {
  for (const char* text :
       {"\x1B", "\n", "\t", "\x7F", "\xC2\x80", "\xC2\x9B", "\xEF\xBF\xBE", "\xEF\xBF\xBF"}) {
    EXPECT_EQ(printable(text), kReplacement);
  }
  EXPECT_EQ(printable(std::string_view("\0", 1)), kReplacement);
}

TEST(Printable, EndsWhereACharacterEnds) {
  const std::string text = "a\xC3\xA4\xFF";
  EXPECT_EQ(printable(text, 0), "");
  EXPECT_EQ(printable(text, 2), "a");
  EXPECT_EQ(printable(text, 3), "a\xC3\xA4");
  EXPECT_EQ(printable(text, 5), "a\xC3\xA4") << "the replacement has three bytes";
  EXPECT_EQ(printable(text, 6), "a\xC3\xA4\xEF\xBF\xBD");
}

}  // namespace
}  // namespace selvage::testbed::test
