// Times of a run beside those of an earlier one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "reports/bench/measurement.h"

namespace selvage::cli {

// What times depend on beside the subjects.
struct Conditions {
  std::string cpu;         // "unknown" where a baseline does not say
  int32_t padding_px = 0;  // of the targets' rows; without any where it does not say
};

struct Baseline {
  std::string source;          // the file
  std::string date, compiler;  // "unknown" where it does not say
  Conditions conditions;
  std::map<std::string, std::map<std::string, double>> ns;  // by item and subject: the medians
};

// From the JSON of `selvage bench`, whole or brief. A UserError says what is wrong with it.
[[nodiscard]] Baseline parse_baseline(const std::string& source, const std::string& text);

struct ComparedTime {
  std::string item, subject;
  double now_ns, then_ns;
  [[nodiscard]] double ratio() const { return now_ns / then_ns; }
};

struct TimeComparison {
  Baseline baseline;
  Conditions conditions;            // of this run
  std::vector<ComparedTime> times;  // what both have, in the order of this run
  size_t only_now = 0;              // measured here, absent from the baseline
};

[[nodiscard]] TimeComparison compare(const std::vector<reports::ItemResult>& results,
                                     const Conditions& conditions, Baseline baseline);

// A row a subject, a column an item, the ratios now / baseline; at most 100 columns.
[[nodiscard]] std::string comparison_table(const TimeComparison& comparison);

}  // namespace selvage::cli
