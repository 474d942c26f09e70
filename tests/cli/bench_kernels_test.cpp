// What `selvage bench` tells of kernels.
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/bench_command.h"
#include "cli/error.h"
#include "support.h"

namespace selvage::cli::test {
namespace {

class BenchKernels : public testing::Test {
 protected:
  BenchKernels() {
    options_.rows = "2";
    options_.repetitions = "3";
    options_.min_time = "0.001";
    options_.filter = "^W1/kernel-";
  }
  [[nodiscard]] std::string output() {
    std::ostringstream out, err;
    EXPECT_EQ(run_bench(options_, {out, err}), kExitFine) << err.str();
    return out.str();
  }

  BenchOptions options_;
};

TEST_F(BenchKernels, AreSubjectsOnRequest) {
  EXPECT_THROW((void)output(), UserError);
  options_.kernels = true;
  const std::string table = output();
  expect_contains(table, "\nkernel-scalar ");
  expect_contains(table, "Fastest kernels, RGBA8888: nearest large ");
  options_.list = true;
  expect_contains(output(), "  kernel-scalar ");
}

TEST_F(BenchKernels, AreToldInJson) {
  options_.filter = "^W1/fill$";
  options_.json = true;
  const nlohmann::json values = nlohmann::json::parse(output());
  for (const char* filter : {"nearest", "four", "bilinear", "area"}) {
    for (const char* work : {"large", "mesh", "perspective"})
      EXPECT_TRUE(values["fastest_kernels"][filter][work].is_string()) << filter << " " << work;
  }
  for (const char* key : {"selvage_kernels", "selvage_kernels_untested"})
    EXPECT_TRUE(values["machine"][key].is_string()) << key;
}

}  // namespace
}  // namespace selvage::cli::test
