// A mapper under measurement: something that draws a workload into a target.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "reports/bench/image.h"
#include "reports/bench/workloads.h"

namespace selvage::reports {

struct Subject {
  std::string id;  // short, for the table's columns and the plots
  std::string title;
  std::string configuration;  // what exactly is timed
  bool textures = true;       // false: draws no texels, so only its pixels are judged
  bool reference = false;     // must agree with the exact model or nothing is timed
  bool judged = true;         // false: a limit that draws no picture, so nothing is judged
  bool bilinear = false;      // can draw workloads whose filter is kBilinear; others are refused
  bool area = false;          // and those whose filter is kArea
  bool threads = false;       // timed by the clock, not by processor time: what draws with several
  // The bits of a texel that reach the target, s and the lower bits of t, or whole channels; the
  // others are not compared. A pixel format without a fourth channel carries 24.
  uint32_t carried_bits = 0xFFFFFFFF;
  double tolerance_texel = 0;   // a reference's texels may lie this far from the exact (u, v)
  std::string group = "peers";  // "ours", "historic", "usual", "peers", "limits": colour in plots

  // Empty if the subject can draw the workload, else why it cannot. Filters are not asked about.
  std::function<std::string(const Workload&)> refusal;

  // Makes ready what depends on the workload alone and returns the drawing that is timed. The
  // workload, the texture and the target outlive it. Also called for parts of a workload, to see
  // which polygons draw a pixel.
  std::function<std::function<void()>(const Workload&, const Texture&, Target&)> prepare;
};

[[nodiscard]] Subject subject_exact();
[[nodiscard]] Subject subject_exact_many(int32_t threads);
[[nodiscard]] std::vector<Subject> subjects_tolerant();
[[nodiscard]] std::vector<Subject> subjects_by_kernel();  // those of this machine
[[nodiscard]] std::vector<Subject> subjects_in_layouts();
[[nodiscard]] std::vector<Subject> subjects_historic();
[[nodiscard]] std::vector<Subject> subjects_arithmetic();
[[nodiscard]] Subject subject_subdivided();
[[nodiscard]] Subject subject_inexact();
[[nodiscard]] std::vector<Subject> subjects_inexact_by_loop();  // those of this machine
[[nodiscard]] Subject subject_memcpy();
[[nodiscard]] Subject subject_touch();
[[nodiscard]] Subject subject_fill();

// The library that this is linked with draws through the filter.
[[nodiscard]] bool mapper_takes(selvage_filter filter);

// The mappers of other projects, one file each under reports/peers: those of the collection that
// the program links (reports/peers/CMakeLists.txt).
struct Peers {
  std::vector<Subject> subjects;
  std::vector<std::string> absent;                       // a sentence each
  std::map<std::string, std::string> build_information;  // by the subject's id
};
[[nodiscard]] Peers peers();

}  // namespace selvage::reports
