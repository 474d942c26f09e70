// What a run measures: which subjects on which workloads.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "reports/bench/curves.h"
#include "reports/bench/subject.h"
#include "reports/bench/workloads.h"

namespace selvage::reports {

struct Item {
  Workload load;
  std::vector<Subject> subjects;
};

// A curve of the plan: its points are items of their own.
struct PlannedCurve {
  Curve curve;
  std::vector<double> xs;
  std::vector<size_t> items;  // one for each x
};

struct Plan {
  std::vector<Item> items;
  size_t work_items = 0;          // the first of the items; the others are curves' points
  std::vector<Subject> subjects;  // each that some work item is asked of, once, in order
  std::vector<PlannedCurve> curves;
  std::vector<std::string> unavailable;  // a sentence for each item or peer that there is not
  std::map<std::string, std::string> build_information;  // of the peers
};

// Whether an item of that id is to be measured for a subject of that id.
using Wanted = std::function<bool(std::string_view item, std::string_view subject)>;

// What takes time of its own and is measured where it is asked for.
struct Extras {
  bool curves = false;
  bool kernels = false;  // a subject for each kernel and inexact loop that this machine can run
};

// All subjects, in the order of the tables: exact first, the solid fill last.
[[nodiscard]] Plan make_plan(uint64_t seed, const Extras& extras, const Wanted& wanted);

}  // namespace selvage::reports
