// Switches: what a mutated expression calls in place of its operator or constant.
//
// All mutants are in one program. A site is one operator or constant; its alternatives have the
// numbers kFirst, kFirst + 1, ..., and one of all alternatives of all sites is active at most.
// Where the compiler evaluates an expression, it is the original.
#pragma once

#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <type_traits>
#include <utility>

namespace selvage::mutants {

inline constexpr int kMost = 1 << 15;

[[nodiscard]] inline int from_environment() {
  const char* const text = std::getenv("SELVAGE_MUTANT");
  return text == nullptr ? 0 : std::atoi(text);
}

inline int active = from_environment();  // 0: none
inline unsigned char reached[kMost];     // at a site's first number
inline unsigned char applies[kMost];     // at an alternative's number: the types have it

// 0: the original; 1, 2, ...: the alternatives of a site.
template <int kFirst>
[[nodiscard]] constexpr int chosen() {
  if (std::is_constant_evaluated()) return 0;
  reached[kFirst] = 1;
  return active < kFirst ? 0 : active - kFirst + 1;
}

template <int kNumber>
constexpr void note_that_it_applies() {
  if (!std::is_constant_evaluated()) applies[kNumber] = 1;
}

#define SELVAGE_OPERATION(name, expression)                              \
  struct name {                                                          \
    template <class A, class B>                                          \
    static constexpr auto of(const A& a, const B& b) requires requires { \
      expression;                                                        \
    }                                                                    \
    { return expression; }                                               \
  }
SELVAGE_OPERATION(Plus, a + b);
SELVAGE_OPERATION(Minus, a - b);
SELVAGE_OPERATION(Times, a* b);
SELVAGE_OPERATION(Over, a / b);
SELVAGE_OPERATION(Modulo, a % b);
SELVAGE_OPERATION(Left, a << b);
SELVAGE_OPERATION(Right, a >> b);
SELVAGE_OPERATION(BitAnd, a& b);
SELVAGE_OPERATION(BitOr, a | b);
SELVAGE_OPERATION(BitXor, a ^ b);
SELVAGE_OPERATION(Less, a < b);
SELVAGE_OPERATION(LessEqual, a <= b);
SELVAGE_OPERATION(Greater, a > b);
SELVAGE_OPERATION(GreaterEqual, a >= b);
SELVAGE_OPERATION(Equal, a == b);
SELVAGE_OPERATION(NotEqual, a != b);
SELVAGE_OPERATION(Least, (a < b ? a : b));
SELVAGE_OPERATION(Greatest, (a > b ? a : b));
#undef SELVAGE_OPERATION

template <class Operation, class A, class B>
inline constexpr bool kHas = requires(const A& a, const B& b) {
  Operation::of(a, b);
};

template <class Result, int kNumber, class Original, class A, class B>
[[nodiscard]] constexpr Result pick(int /*which*/, A a, B b) {
  return Original::of(a, b);
}
template <class Result, int kNumber, class Original, class A, class B, class Next, class... Rest>
[[nodiscard]] constexpr Result pick(int which, A a, B b) {
  if constexpr (kHas<Next, A, B>) {
    note_that_it_applies<kNumber>();
    if (which == 1) return static_cast<Result>(Next::of(a, b));
  }
  return pick<Result, kNumber + 1, Original, A, B, Rest...>(which - 1, a, b);
}

// a OP b
template <int kFirst, class Original, class... Others, class A, class B>
[[nodiscard]] constexpr auto binary(A a, B b) {
  using Result = decltype(Original::of(a, b));
  return pick<Result, kFirst, Original, A, B, Others...>(chosen<kFirst>(), a, b);
}

// OP({a, b, ...}), from left to right
template <int kFirst, class Original, class... Others, class A>
[[nodiscard]] constexpr A binary(std::initializer_list<A> values) {
  A result = *values.begin();
  for (const A& value : values) result = binary<kFirst, Original, Others...>(result, value);
  return result;
}

// a OP= b
template <int kFirst, class Original, class... Others, class A, class B>
constexpr A& assign(A& a, B b) {
  return a = static_cast<A>(binary<kFirst, Original, Others...>(a, b));
}

// ++a, a++ and the like
template <int kFirst, int kStep, class A>
constexpr A& stepped(A& a) {
  note_that_it_applies<kFirst>();
  return a = static_cast<A>(chosen<kFirst>() == 1 ? a - kStep : a + kStep);
}
template <int kFirst, int kStep, class A>
constexpr A stepped_after(A& a) {
  const A before = a;
  stepped<kFirst, kStep>(a);
  return before;
}

// a && b is turned(turned(a) && turned(b)), and so is a || b: all three turned, each is the other.
template <int kFirst, class A>
[[nodiscard]] constexpr bool turned(const A& a) {
  note_that_it_applies<kFirst>();
  return static_cast<bool>(a) != (chosen<kFirst>() == 1);
}

// !a, -a and ~a, or a
template <int kFirst, class A>
[[nodiscard]] constexpr bool negation(const A& a) {
  note_that_it_applies<kFirst>();
  return static_cast<bool>(a) == (chosen<kFirst>() == 1);
}
template <int kFirst, class A>
[[nodiscard]] constexpr auto opposite(const A& a) {
  note_that_it_applies<kFirst>();
  return chosen<kFirst>() == 1 ? decltype(-a)(a) : -a;
}
template <int kFirst, class A>
[[nodiscard]] constexpr auto complement(const A& a) {
  note_that_it_applies<kFirst>();
  return chosen<kFirst>() == 1 ? decltype(~a)(a) : ~a;
}

// A literal or a named constant: one more and one less; of floating point twice and half of it (of
// 0: 1 and -1); of truth the opposite.
template <int kFirst, class A>
[[nodiscard]] constexpr A constant(A a) {
  int which = chosen<kFirst>();  // not const: that would ask the compiler to evaluate it
  note_that_it_applies<kFirst>();
  if constexpr (std::is_same_v<A, bool>) {
    return a != (which == 1);
  } else {
    note_that_it_applies<kFirst + 1>();
    if (which != 1 && which != 2) return a;
    if constexpr (std::is_floating_point_v<A>) {
      return a == 0 ? (which == 1 ? A{1} : A{-1}) : (which == 1 ? 2 * a : a / 2);
    } else {
      return static_cast<A>(which == 1 ? a + 1 : a - 1);
    }
  }
}

// std::floor, or std::ceil; std::abs, or nothing.
template <int kFirst, class A>
[[nodiscard]] A floored(A a) {
  note_that_it_applies<kFirst>();
  return chosen<kFirst>() == 1 ? std::ceil(a) : std::floor(a);
}
template <int kFirst, class A>
[[nodiscard]] A magnitude_of(A a) {
  note_that_it_applies<kFirst>();
  return chosen<kFirst>() == 1 ? a : std::abs(a);
}

}  // namespace selvage::mutants

// Highway's macros as functions, so that what is in them has one place in the text.
namespace selvage {

template <class A, class B>
[[nodiscard]] constexpr auto hwy_min(const A& a, const B& b) {
  return a < b ? a : b;
}
template <class A, class B>
[[nodiscard]] constexpr auto hwy_max(const A& a, const B& b) {
  return a > b ? a : b;
}
[[nodiscard]] constexpr bool hwy_likely(bool a) { return a; }
[[nodiscard]] constexpr bool hwy_unlikely(bool a) { return a; }

}  // namespace selvage
