#include "cli/number.h"

#include <gtest/gtest.h>

namespace selvage::cli::test {
namespace {

TEST(ShowBeside, TakesThreeDigitsOrWhatTellsTheLimit) {
  EXPECT_EQ(show_beside(1.112712745, 1), "1.11");
  EXPECT_EQ(show_beside(1.0004, 1), "1.0004");
  EXPECT_EQ(show_beside(0.99999, 1), "0.99999");
  EXPECT_EQ(show_beside(0.25004, 0.25), "0.25004");
  EXPECT_EQ(show_beside(0.25, 0.25), "0.25");
  EXPECT_EQ(show_beside(0.2496, 0.25), "0.2496");
  EXPECT_EQ(show_beside(1.067471716e-05, 0), "1.07e-05");
  EXPECT_EQ(show_beside(0, 0), "0");
  EXPECT_EQ(show_beside(937.5741943, 1), "938");
  EXPECT_EQ(show_beside(12345.678, 1), "12346");
  EXPECT_EQ(show_beside(99999.9, 1), "99999.9");
  EXPECT_EQ(show_beside(-999.9, 1), "-999.9");
  EXPECT_EQ(show_beside(2.5e12, 1), "2.5e+12");
  EXPECT_EQ(show_beside(1 + 0x1p-52, 1), "1.0000000000000002");
}

}  // namespace
}  // namespace selvage::cli::test
