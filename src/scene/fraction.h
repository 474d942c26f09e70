// Which of two fractions is greater, exactly, whatever products it would take to cross-multiply.
#pragma once

#include <compare>
#include <utility>

namespace selvage::scene {

__extension__ typedef unsigned __int128 Unsigned128;
__extension__ typedef __int128 Signed128;

struct Fraction {
  Unsigned128 numerator, denominator;  // the denominator is not 0
};

// By their continued fractions: whole parts first, then the reciprocals of what is left, which
// compare the other way. Ends like Euclid's algorithm; numbers only get smaller.
[[nodiscard]] constexpr std::strong_ordering compare(Fraction a, Fraction b) {
  for (bool reciprocal = false;; reciprocal = !reciprocal) {
    const auto told = [&](std::strong_ordering order) { return reciprocal ? 0 <=> order : order; };
    const Unsigned128 a_whole = a.numerator / a.denominator;
    const Unsigned128 b_whole = b.numerator / b.denominator;
    if (a_whole != b_whole) return told(a_whole <=> b_whole);
    a.numerator -= a_whole * a.denominator;
    b.numerator -= b_whole * b.denominator;
    if (a.numerator == 0 || b.numerator == 0)
      return told((a.numerator != 0) <=> (b.numerator != 0));
    std::swap(a.numerator, a.denominator);
    std::swap(b.numerator, b.denominator);
  }
}

}  // namespace selvage::scene
