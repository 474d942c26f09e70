// Calls with one odd argument each: a bad one and the error that it must get, or one that is legal
// although it looks bad.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "spec/case.h"
#include "spec/subject.h"

namespace selvage::spec {

// The arguments of a draw call, ready to be spoiled.
struct Arguments {
  selvage_image target;
  selvage_rect clip;
  std::vector<selvage_vertex> vertices;
  selvage_texture texture;
  selvage_options options;
  // What the call is given; each points at its field above, or elsewhere once spoiled.
  const selvage_image* target_pointer;
  const selvage_vertex* vertices_pointer;
  const selvage_texture* texture_pointer;
  const selvage_rect* clip_pointer;
  const selvage_options* options_pointer;
  size_t count;
};

struct HostileCall {
  std::string what;
  selvage_status wanted;
  std::function<void(Arguments&)> spoil;
};

struct HostileOutcome {
  selvage_status status;
  bool target_untouched;
};

// Those that make sense for the case's profile, format and size, and for what the subject has: all
// filters or only nearest, prepared textures or none.
[[nodiscard]] std::vector<HostileCall> hostile_calls(const Case& c, const Subject& subject);

// What is spoiled: a good triangle with the case's images.
[[nodiscard]] Case good_drawing(const Subject& subject, const Case& c);
// Draws it, spoiled.
[[nodiscard]] HostileOutcome make(const Subject& subject, const Case& good,
                                  const HostileCall& call);

}  // namespace selvage::spec
