// Lists of polygons with one odd argument each, as hostile_calls.h has them of one polygon.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "spec/case.h"
#include "spec/hostile_calls.h"
#include "spec/subject.h"

namespace selvage::spec {

// The arguments of a draw_many call, ready to be spoiled: a good drawing, several times.
struct ListArguments {
  selvage_image target;
  selvage_texture texture;
  std::vector<std::vector<selvage_vertex>> outlines;
  std::vector<selvage_polygon> polygons;
  selvage_options options;
  int32_t threads;
  // What the call is given.
  const selvage_image* target_pointer;
  const selvage_polygon* polygons_pointer;
  size_t count;
};

struct HostileList {
  std::string what;
  selvage_status wanted;
  std::function<void(ListArguments&)> spoil;
  std::optional<size_t> failed{};  // the polygon to blame
  bool draws = false;
};

struct ListOutcome {
  selvage_status status;
  bool target_untouched;
  std::optional<size_t> failed;  // that it told
};

[[nodiscard]] std::vector<HostileList> hostile_lists(const Case& c);

// Draws them, spoiled; of a subject that has a call for many.
[[nodiscard]] ListOutcome make(const Subject& subject, const Case& good, const HostileList& list);

}  // namespace selvage::spec
