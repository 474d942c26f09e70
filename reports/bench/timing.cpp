#include "reports/bench/timing.h"

#include <benchmark/benchmark.h>

#include <map>
#include <stdexcept>

namespace selvage::reports {

namespace {

class Collector : public benchmark::BenchmarkReporter {
 public:
  explicit Collector(const std::vector<Timed>& timed) {
    for (const Timed& one : timed) by_the_clock_[one.name] = one.by_the_clock;
  }

  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.error_occurred) throw std::runtime_error(run.run_name.str() + run.error_message);
      if (run.run_type != Run::RT_Iteration) continue;
      const std::string& name = run.run_name.function_name;
      const double time_s =
          by_the_clock_.at(name) ? run.real_accumulated_time : run.cpu_accumulated_time;
      times_ns_[name].push_back(time_s * 1e9 / static_cast<double>(run.iterations));
    }
  }

  [[nodiscard]] const std::vector<double>& times_ns(const std::string& name) const {
    return times_ns_.at(name);
  }

 private:
  std::map<std::string, std::vector<double>> times_ns_;
  std::map<std::string, bool> by_the_clock_;
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
    auto* const registered =
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
            ->MeasureProcessCPUTime();
    if (one.by_the_clock) registered->UseRealTime();
  }
  Collector collector(timed);
  benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::ClearRegisteredBenchmarks();
  benchmark::Shutdown();
  std::vector<std::vector<double>> times_ns;
  for (const Timed& one : timed) times_ns.push_back(collector.times_ns(one.name));
  return times_ns;
}

}  // namespace selvage::reports
