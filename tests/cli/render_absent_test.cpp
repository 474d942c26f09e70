// `selvage render` in a build without scenes.
#include <sstream>

#include "cli/render_command.h"
#include "support.h"

namespace selvage::cli::test {
namespace {

TEST(RenderAbsent, SaysWhatToInstall) {
  std::ostringstream out, err;
  const std::string error = error_of([&] { run_render({}, {out, err}); });
  expect_contains(error, "built without scenes");
  expect_contains(error, "libeigen3-dev");
  EXPECT_EQ(out.str() + err.str(), "");
}

}  // namespace
}  // namespace selvage::cli::test
