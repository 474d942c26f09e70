// A value that goes from a to b in equal steps and is rounded at each: floor(value + 1/2), exactly.
//
// The classroom notes add a fraction per step; a quotient and a remainder do so without its drift.
#pragma once

#include <cstdint>

#include "mapper/number.h"

namespace selvage::historic {

class RoundedWalk {
 public:
  RoundedWalk() = default;

  // a and b are in 1/unit of what is rounded; steps > 0. |a|, |b| <= 2^31 in 1/unit, unit and steps
  // at most 2^16: below, no number exceeds 2^51.
  RoundedWalk(int64_t a, int64_t b, int64_t steps, int64_t unit) : divisor_(2 * steps * unit) {
    const int64_t dividend = 2 * a * steps + steps * unit;
    quotient_ = mapper::floor_div(dividend, divisor_);
    remainder_ = dividend - quotient_ * divisor_;
    step_quotient_ = mapper::floor_div(2 * (b - a), divisor_);
    step_remainder_ = 2 * (b - a) - step_quotient_ * divisor_;
  }

  [[nodiscard]] int32_t texel() const { return static_cast<int32_t>(quotient_); }
  [[nodiscard]] int32_t texel(int32_t steps) const {
    RoundedWalk there = *this;
    there.advance(steps);
    return there.texel();
  }
  void step() {
    quotient_ += step_quotient_;
    remainder_ += step_remainder_;
    if (remainder_ >= divisor_) {
      remainder_ -= divisor_;
      ++quotient_;
    }
  }
  void advance(int64_t steps) {
    remainder_ += step_remainder_ * steps;
    quotient_ += step_quotient_ * steps + remainder_ / divisor_;
    remainder_ %= divisor_;
  }
  [[nodiscard]] bool is_unit() const { return step_quotient_ == 1 && step_remainder_ == 0; }
  [[nodiscard]] bool is_constant() const { return step_quotient_ == 0 && step_remainder_ == 0; }

 private:
  int64_t divisor_ = 1;
  int64_t quotient_ = 0, remainder_ = 0;  // 0 <= remainder < divisor
  int64_t step_quotient_ = 0, step_remainder_ = 0;
};

}  // namespace selvage::historic
