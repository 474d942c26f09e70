#include "reports/bench/curves.h"

namespace selvage::reports {

std::vector<Series> usual_series() {
  std::vector<Subject> subjects{subject_exact(), subjects_tolerant().back()};
  for (Subject& subject : subjects_arithmetic()) {
    if (subject.id == "fixed1616" || subject.id == "float32-dda")
      subjects.push_back(std::move(subject));
  }
  subjects.push_back(subject_fill());
  subjects.push_back(subject_inexact());
  std::vector<Series> series;
  for (const Subject& subject : subjects)
    series.push_back({subject.id, [subject](double) { return subject; }});
  return series;
}

std::vector<Curve> curves() {
  return {curve_polygon_size(), curve_texture_size(), curve_scale(),      curve_off_screen(),
          curve_direction(),    curve_threads("W1"),  curve_threads("W3")};
}

}  // namespace selvage::reports
