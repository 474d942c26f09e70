#include <gtest/gtest.h>

#include <set>
#include <string>

#include "selvage.h"

namespace {

TEST(Status, EveryOneHasATextOfItsOwn) {
  std::set<std::string> texts;
  for (selvage_status status = SELVAGE_OK; status < SELVAGE_STATUS_COUNT; ++status) {
    const std::string text = selvage_status_text(status);
    EXPECT_NE(text, "unknown status") << status;
    EXPECT_TRUE(texts.insert(text).second) << text;
  }
}

TEST(Status, UnknownOnesAreSaidToBe) {
  for (const selvage_status status : {-1, int{SELVAGE_STATUS_COUNT}, INT32_MIN, INT32_MAX}) {
    EXPECT_STREQ(selvage_status_text(status), "unknown status");
  }
}

TEST(Version, IsTheHeaders) {
  EXPECT_EQ(selvage_version(), std::to_string(SELVAGE_VERSION_MAJOR) + "." +
                                   std::to_string(SELVAGE_VERSION_MINOR) + "." +
                                   std::to_string(SELVAGE_VERSION_PATCH));
}

}  // namespace
