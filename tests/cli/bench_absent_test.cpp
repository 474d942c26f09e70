// `selvage bench` in a build without Google Benchmark.
#include <sstream>

#include "cli/bench_command.h"
#include "support.h"

namespace selvage::cli::test {
namespace {

TEST(BenchAbsent, SaysWhatToInstall) {
  std::ostringstream out, err;
  const std::string error = error_of([&] { run_bench({}, {out, err}); });
  expect_contains(error, "built without Google Benchmark");
  expect_contains(error, "Install libbenchmark-dev");
  EXPECT_EQ(out.str() + err.str(), "");
}

}  // namespace
}  // namespace selvage::cli::test
