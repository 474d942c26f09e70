// Integers of 128 bits out of two of 64, for compilers that have none: what the mapper asks of
// them, and with the meaning of gcc's __int128. Two's complement, modulo 2^128; there is no
// division, for the mapper divides none.
#pragma once

#include <bit>
#include <compare>
#include <concepts>
#include <cstdint>
#include <type_traits>

namespace selvage::mapper {

template <bool is_signed>
class Integer128 {
 public:
  Integer128() = default;
  // Sign-extended, as built-in integers are.
  template <std::integral Integer>
  constexpr Integer128(Integer a)
      : low_(static_cast<uint64_t>(a)), high_(a < Integer{0} ? ~uint64_t{0} : 0) {}
  constexpr explicit Integer128(Integer128<!is_signed> a) : low_(a.low_), high_(a.high_) {}

  template <std::integral Integer>
  requires(!std::same_as<Integer, bool>) constexpr explicit operator Integer() const {
    return static_cast<Integer>(low_);
  }
  // Rounded once, to the nearest.
  constexpr explicit operator double() const {
    if (is_negative()) return -static_cast<double>(Integer128<false>(-*this));
    if (high_ == 0) return static_cast<double>(low_);
    const auto bits = static_cast<int>(std::bit_width(high_));
    const bool is_rest = (low_ << (kHalf - bits)) != 0;  // below the 64 highest bits
    const auto top = static_cast<uint64_t>(*this >> bits) | (is_rest ? 1U : 0U);
    double scale = 1;
    for (int bit = 0; bit < bits; ++bit) scale *= 2;
    return static_cast<double>(top) * scale;
  }

  friend constexpr bool operator==(Integer128, Integer128) = default;
  friend constexpr std::strong_ordering operator<=>(Integer128 a, Integer128 b) {
    if (a.is_negative() != b.is_negative())
      return a.is_negative() ? std::strong_ordering::less : std::strong_ordering::greater;
    return a.high_ != b.high_ ? a.high_ <=> b.high_ : a.low_ <=> b.low_;
  }

  constexpr Integer128 operator~() const { return {~low_, ~high_}; }
  constexpr Integer128 operator-() const { return Integer128{0} - *this; }
  friend constexpr Integer128 operator+(Integer128 a, Integer128 b) {
    const uint64_t low = a.low_ + b.low_;
    return {low, a.high_ + b.high_ + (low < a.low_ ? 1 : 0)};
  }
  friend constexpr Integer128 operator-(Integer128 a, Integer128 b) {
    return {a.low_ - b.low_, a.high_ - b.high_ - (a.low_ < b.low_ ? 1 : 0)};
  }
  friend constexpr Integer128 operator*(Integer128 a, Integer128 b) {
    Integer128 result = product(a.low_, b.low_);
    result.high_ += a.high_ * b.low_ + a.low_ * b.high_;
    return result;
  }
  friend constexpr Integer128 operator&(Integer128 a, Integer128 b) {
    return {a.low_ & b.low_, a.high_ & b.high_};
  }
  friend constexpr Integer128 operator|(Integer128 a, Integer128 b) {
    return {a.low_ | b.low_, a.high_ | b.high_};
  }
  // By 0 to 127 bits.
  friend constexpr Integer128 operator<<(Integer128 a, int bits) {
    if (bits == 0) return a;
    if (bits >= kHalf) return {0, a.low_ << (bits - kHalf)};
    return {a.low_ << bits, (a.high_ << bits) | (a.low_ >> (kHalf - bits))};
  }
  friend constexpr Integer128 operator>>(Integer128 a, int bits) {
    if (bits == 0) return a;
    if (bits >= kHalf) return {a.high_down(bits - kHalf), a.is_negative() ? ~uint64_t{0} : 0};
    return {(a.low_ >> bits) | (a.high_ << (kHalf - bits)), a.high_down(bits)};
  }
  constexpr Integer128& operator+=(Integer128 b) { return *this = *this + b; }
  constexpr Integer128& operator-=(Integer128 b) { return *this = *this - b; }
  constexpr Integer128& operator<<=(int bits) { return *this = *this << bits; }
  constexpr Integer128& operator>>=(int bits) { return *this = *this >> bits; }

 private:
  template <bool>
  friend class Integer128;
  using High = std::conditional_t<is_signed, int64_t, uint64_t>;
  static constexpr int kHalf = 64;

  constexpr Integer128(uint64_t low, uint64_t high) : low_(low), high_(high) {}
  [[nodiscard]] constexpr bool is_negative() const { return static_cast<High>(high_) < High{0}; }
  [[nodiscard]] constexpr uint64_t high_down(int bits) const {
    return static_cast<uint64_t>(static_cast<High>(high_) >> bits);
  }
  // By parts of 32 bits, as on paper.
  [[nodiscard]] static constexpr Integer128 product(uint64_t a, uint64_t b) {
    constexpr int kPart = 32;
    const uint64_t mask = ~uint32_t{0};
    const uint64_t lowest = (a & mask) * (b & mask);
    const uint64_t cross = (a >> kPart) * (b & mask) + (lowest >> kPart);
    const uint64_t middle = (a & mask) * (b >> kPart) + (cross & mask);
    return {(middle << kPart) | (lowest & mask),
            (a >> kPart) * (b >> kPart) + (cross >> kPart) + (middle >> kPart)};
  }

  uint64_t low_, high_;
};

}  // namespace selvage::mapper
