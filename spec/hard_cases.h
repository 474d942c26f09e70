// Hard cases by name: families of cases that each stress one thing mappers get wrong.
//
// Of every family, even seeds have their vertices on whole pixels, where what the family stresses
// allows it, so that mappers without sub-pixel positions can be held to them; seeds 0 and 1 modulo
// 4 have small targets, for laws that draw often and for fuzzing.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "spec/case.h"

namespace selvage::spec {

struct HardFamily {
  std::string_view name;        // lower-case words and numbers joined by hyphens
  std::string_view reason;      // one sentence: what goes wrong here in mappers without care
  Case (*make)(uint64_t seed);  // the case of a seed: the same on every machine
};

[[nodiscard]] std::span<const HardFamily> hard_families();
[[nodiscard]] const HardFamily* find_hard_family(std::string_view name);  // nullptr if none

// The width x height of small targets is at most this.
inline constexpr int32_t kSmallTargetPx = 1024;

}  // namespace selvage::spec
