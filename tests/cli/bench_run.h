// `selvage bench` of few subjects and no time, for tests that change what it is asked for.
#pragma once

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "cli/bench_command.h"
#include "cli/bench_report.h"
#include "support.h"

namespace selvage::cli::test {

class Bench : public InDirectory {
 protected:
  Bench() {
    options_.rows = "2";
    options_.repetitions = "3";
    options_.min_time = "0.001";
    options_.filter = "^W1/(exact|fixed1616|fill|memcpy)$";
  }

  int run() {
    out_.str("");
    err_.str("");
    return run_bench(options_, {out_, err_});
  }
  int run(const reports::Plan& plan) {
    out_.str("");
    err_.str("");
    return run_plan(plan, options_, {out_, err_});
  }
  [[nodiscard]] std::string out() const { return out_.str(); }
  [[nodiscard]] std::string err() const { return err_.str(); }
  [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(out()); }

  BenchOptions options_;

 private:
  std::ostringstream out_, err_;
};

}  // namespace selvage::cli::test
