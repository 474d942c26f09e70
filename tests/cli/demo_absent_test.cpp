// `selvage demo` in a build without SDL2 or scenes.
#include <sstream>

#include "cli/demo_command.h"
#include "support.h"

namespace selvage::cli::test {
namespace {

TEST(DemoAbsent, SaysWhatToInstall) {
  std::ostringstream out, err;
  const std::string error = error_of([&] { run_demo({}, {out, err}); });
  expect_contains(error, "built without the demo");
  expect_contains(error, "libsdl2-dev");
  EXPECT_EQ(out.str() + err.str(), "");
}

}  // namespace
}  // namespace selvage::cli::test
