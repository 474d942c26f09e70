#include "reports/bench/timing.h"

#include <benchmark/benchmark.h>

#include <map>
#include <stdexcept>

namespace selvage::reports {

namespace {

class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.error_occurred) throw std::runtime_error(run.run_name.str() + run.error_message);
      if (run.run_type != Run::RT_Iteration) continue;
      times_ns_[run.run_name.function_name].push_back(run.real_accumulated_time * 1e9 /
                                                      static_cast<double>(run.iterations));
    }
  }

  [[nodiscard]] const std::vector<double>& times_ns(const std::string& name) const {
    return times_ns_.at(name);
  }

 private:
  std::map<std::string, std::vector<double>> times_ns_;
};

// Google Benchmark takes the interleaving from its command line only.
void initialize() {
  std::string program = "selvage", interleave = "--benchmark_enable_random_interleaving=true";
  char* arguments[] = {program.data(), interleave.data(), nullptr};
  int count = 2;
  benchmark::Initialize(&count, arguments);
}

}  // namespace

std::vector<std::vector<double>> measure_ns(const std::vector<Timed>& timed,
                                            const TimingOptions& options,
                                            const std::function<void()>& tick) {
  if (timed.empty()) return {};
  initialize();
  for (const Timed& one : timed) {
    benchmark::RegisterBenchmark(one.name.c_str(),
                                 [&one, &tick](benchmark::State& state) {
                                   tick();
                                   for ([[maybe_unused]] const auto pass : state) {
                                     one.draw();
                                     benchmark::ClobberMemory();
                                   }
                                 })
        ->Repetitions(options.repetitions)
        ->MinTime(options.min_time_s)
        ->UseRealTime();
  }
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();
  benchmark::Shutdown();
  std::vector<std::vector<double>> times_ns;
  for (const Timed& one : timed) times_ns.push_back(collector.times_ns(one.name));
  return times_ns;
}

}  // namespace selvage::reports
