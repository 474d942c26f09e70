// Cost against one quantity: the same drawing over a range of it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reports/bench/subject.h"

namespace selvage::reports {

// A line of the plot. Its subject may depend on x: a mapper with that many threads, say.
struct Series {
  std::string id;
  std::function<Subject(double x)> subject_at;
};

struct Curve {
  std::string id;  // one word, for file names and filters
  std::string title;
  std::string description;  // what is drawn, and what changes with x
  std::string axis;         // x, with its unit
  std::vector<double> xs;   // ascending, > 0: axes are logarithmic
  std::function<Workload(double x)> load_at;
  std::vector<Series> series;
};

// The series that most curves have: exact, the loosest tolerance, 16.16, float, solid fill, inexact
// vector lanes.
[[nodiscard]] std::vector<Series> usual_series();

// One file each. To add one: a file with a function, and its call in curves().
[[nodiscard]] Curve curve_polygon_size();
[[nodiscard]] Curve curve_texture_size();
[[nodiscard]] Curve curve_scale();
[[nodiscard]] Curve curve_off_screen();
[[nodiscard]] Curve curve_direction();
[[nodiscard]] Curve curve_threads(const std::string& item);  // of W1 .. W6

[[nodiscard]] std::vector<Curve> curves();

}  // namespace selvage::reports
