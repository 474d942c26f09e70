// How large the shrunk counterexample of a wrong mapper may be: a person has to look at it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "spec/case.h"

namespace selvage::coverage {

struct CounterexampleSize {
  size_t vertices = 4;
  int32_t target_px = 16;      // width + height
  int32_t texture_texel = 60;  // likewise
};

// A bug that cannot be seen on less.
struct LargeCounterexample {
  std::string_view mapper;
  CounterexampleSize size;
  std::string_view why;
};
[[nodiscard]] std::span<const LargeCounterexample> large_counterexamples();

// Of the named mapper.
[[nodiscard]] CounterexampleSize largest_counterexample(std::string_view mapper);

[[nodiscard]] CounterexampleSize size_of(const spec::Case& c);

}  // namespace selvage::coverage
