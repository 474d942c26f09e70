// What the tests of the benchmark share: small workloads, and subjects that err on purpose.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "reports/bench/measurement.h"

namespace selvage::reports::test {

// An upright rectangle of columns [left, right) and rows [top, bottom), with texel (s, t) at pixel
// (s, t) plus `off_texel`.
[[nodiscard]] inline std::vector<selvage_vertex> rectangle(int32_t left, int32_t top, int32_t right,
                                                           int32_t bottom, double off_texel = 0) {
  std::vector<selvage_vertex> polygon;
  const auto off_fx16 = static_cast<int32_t>(off_texel * 65536);
  for (const auto& [x, y] : {std::pair(left, top), std::pair(right, top), std::pair(right, bottom),
                             std::pair(left, bottom)})
    polygon.push_back({x * 256, y * 256, x * 65536 + off_fx16, y * 65536 + off_fx16, 1});
  return polygon;
}

[[nodiscard]] inline Workload small_workload(std::vector<std::vector<selvage_vertex>> polygons) {
  Workload load;
  load.id = "small";
  load.target_side_px = 32;
  load.texture_side_texel = 64;
  load.polygons = std::move(polygons);
  return load;
}

// Draws the pixels of each polygon's bounding box, `more` of them beyond its right side, each the
// texel at its own place plus (ds, 0).
[[nodiscard]] inline Subject box_subject(std::string id, int32_t more_px, int32_t ds_texel) {
  Subject subject;
  subject.id = std::move(id);
  subject.refusal = [](const Workload&) { return std::string(); };
  subject.prepare = [=](const Workload& load, const Texture&,
                        Target& target) -> std::function<void()> {
    return [=, &load, &target] {
      for (const auto& polygon : load.polygons) {
        for (int32_t y = polygon[0].y / 256; y < polygon[2].y / 256; ++y) {
          for (int32_t x = polygon[0].x / 256; x < polygon[2].x / 256 + more_px; ++x)
            target.row(y)[x] = place_of(x + ds_texel, y);
        }
      }
    };
  };
  return subject;
}

// A plan of one item.
[[nodiscard]] inline Plan plan_of(Workload load, std::vector<Subject> subjects) {
  Plan plan;
  plan.subjects = subjects;
  plan.items.push_back({std::move(load), std::move(subjects)});
  plan.work_items = 1;
  return plan;
}

[[nodiscard]] inline BenchSettings quick_settings() {
  BenchSettings settings;
  settings.rows = 32;
  settings.timing.repetitions = 3;
  settings.timing.min_time_s = 0.001;
  return settings;
}

inline void ignore_progress(std::string_view, uint64_t, uint64_t) {}

}  // namespace selvage::reports::test
