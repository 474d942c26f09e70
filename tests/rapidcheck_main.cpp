// RapidCheck runs 1 000 cases a property unless RC_PARAMS says otherwise, and always tells its
// seed.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const char* given = std::getenv("RC_PARAMS");
  std::string parameters = given != nullptr ? given : "";
  if (parameters.find("max_success") == std::string::npos) parameters += " max_success=1000";
  setenv("RC_PARAMS", parameters.c_str(), /*overwrite=*/1);
  return RUN_ALL_TESTS();
}
