// Repeated timing of drawings, through Google Benchmark.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace selvage::reports {

struct Timed {
  std::string name;
  std::function<void()> draw;
  bool by_the_clock = false;  // else by the processor time of all threads of the process
};

struct TimingOptions {
  int32_t repetitions = 15;
  double min_time_s = 0.03;  // of one repetition of one drawing
};

// The time of one draw in ns, a value a repetition, in the order of `timed`. Processor time leaves
// out what other programs took meanwhile; for a drawing on one thread that is all the difference to
// the time that passed, and more threads win nothing by it. Repetitions of different drawings are
// interleaved at random, so that a change of the machine's speed during the run widens every spread
// instead of favouring one drawing. tick is called as each run begins.
[[nodiscard]] std::vector<std::vector<double>> measure_ns(const std::vector<Timed>& timed,
                                                          const TimingOptions& options,
                                                          const std::function<void()>& tick);

}  // namespace selvage::reports
