// Random numbers that are the same on every machine: for cases, never for secrets.
//
// Two calls within one expression are only in a known order inside braces; elsewhere a call gets a
// statement of its own, or compilers would disagree about the cases.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace selvage::spec {

// SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014).
class Random {
 public:
  explicit Random(uint64_t seed) : state_(mix(seed)) {}

  [[nodiscard]] uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15u;
    return mix(state_);
  }

  // In [first, end), which holds at least one number and at most 2^32, all within int32_t.
  [[nodiscard]] int32_t in(int64_t first, int64_t end) {
    const uint64_t high = bits() >> 32;
    const uint64_t offset = (high * static_cast<uint64_t>(end - first)) >> 32;
    return static_cast<int32_t>(first + static_cast<int64_t>(offset));
  }

  [[nodiscard]] size_t below(size_t end) {
    return static_cast<size_t>(in(0, static_cast<int64_t>(end)));
  }

  [[nodiscard]] bool percent(int chance) { return in(0, 100) < chance; }

  // One of the values, each as likely as the others.
  template <typename Value, size_t kCount>
  [[nodiscard]] Value pick(const Value (&values)[kCount]) {
    return values[below(kCount)];
  }

 private:
  [[nodiscard]] static constexpr uint64_t mix(uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  uint64_t state_;
};

// One way of making something, and how often it is taken in comparison with the others.
template <typename Make>
struct Weighted {
  int weight;
  Make make;
};

template <typename Make>
[[nodiscard]] Make choose(Random& random, std::span<const Weighted<Make>> table) {
  int total = 0;
  for (const Weighted<Make>& entry : table) total += entry.weight;
  int left = random.in(0, total);
  for (const Weighted<Make>& entry : table) {
    if (left < entry.weight) return entry.make;
    left -= entry.weight;
  }
  return table.back().make;
}

}  // namespace selvage::spec
