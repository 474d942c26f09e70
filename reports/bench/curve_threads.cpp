#include <algorithm>
#include <stdexcept>
#include <thread>

#include "reports/bench/curves.h"

namespace selvage::reports {

namespace {

constexpr uint64_t kMeshSeed = 1;

// 1, 2, 4 and so on, and last twice the machine's cores.
std::vector<double> thread_counts() {
  const unsigned most = 2 * std::max(std::thread::hardware_concurrency(), 1u);
  std::vector<double> counts;
  for (unsigned count = 1; count < most; count *= 2) counts.push_back(count);
  counts.push_back(most);
  return counts;
}

Workload item_of(const std::string& id) {
  for (Workload& load : workloads(kMeshSeed)) {
    if (load.id == id) return std::move(load);
  }
  throw std::logic_error("no work item " + id);
}

// One measure for all lines of the plot.
Subject by_the_clock(Subject subject) {
  subject.threads = true;
  return subject;
}

}  // namespace

Curve curve_threads(const std::string& item) {
  const Workload load = item_of(item);
  Curve curve;
  curve.id = "threads-" + item;
  curve.title = "Cost against threads, " + item;
  curve.description = load.description +
                      "; one call of selvage_draw_many with that many threads, up to twice the "
                      "cores of this machine; exact and fill draw on one; all by the clock";
  curve.axis = "threads";
  curve.xs = thread_counts();
  curve.load_at = [load](double) { return load; };
  const auto many = [](double threads) {
    return by_the_clock(subject_exact_many(static_cast<int32_t>(threads)));
  };
  const auto exact = [](double) { return by_the_clock(subject_exact()); };
  const auto fill = [](double) { return by_the_clock(subject_fill()); };
  curve.series = {{"exact-many", many}, {"exact", exact}, {"fill", fill}};
  return curve;
}

}  // namespace selvage::reports
