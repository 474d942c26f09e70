#include "cli/bench_command.h"
#include "cli/error.h"

namespace selvage::cli {

int run_bench(const BenchOptions&, const Console&) {
  throw UserError(
      "this selvage was built without Google Benchmark and cannot measure. Install "
      "libbenchmark-dev "
      "(or what your system calls it), then configure with SELVAGE_BENCH=ON and build again");
}

}  // namespace selvage::cli
