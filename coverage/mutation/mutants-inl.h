// Switches of calls of Highway. Included within the anonymous namespace of each SIMD target, where
// `hn` is known, so there is no guard of its own.

#define SELVAGE_VECTOR_OPERATION(name, call)   \
  struct Vector##name {                        \
    template <class... A>                      \
    static HWY_INLINE auto of(const A&... a) { \
      return call;                             \
    }                                          \
  }
SELVAGE_VECTOR_OPERATION(Add, hn::Add(a...));
SELVAGE_VECTOR_OPERATION(Sub, hn::Sub(a...));
SELVAGE_VECTOR_OPERATION(Mul, hn::Mul(a...));
SELVAGE_VECTOR_OPERATION(Div, hn::Div(a...));
SELVAGE_VECTOR_OPERATION(MulAdd, hn::MulAdd(a...));
SELVAGE_VECTOR_OPERATION(MulSub, hn::MulSub(a...));
SELVAGE_VECTOR_OPERATION(Min, hn::Min(a...));
SELVAGE_VECTOR_OPERATION(Max, hn::Max(a...));
SELVAGE_VECTOR_OPERATION(And, hn::And(a...));
SELVAGE_VECTOR_OPERATION(Or, hn::Or(a...));
SELVAGE_VECTOR_OPERATION(Xor, hn::Xor(a...));
SELVAGE_VECTOR_OPERATION(Lt, hn::Lt(a...));
SELVAGE_VECTOR_OPERATION(Eq, hn::Eq(a...));
SELVAGE_VECTOR_OPERATION(Ne, hn::Ne(a...));
SELVAGE_VECTOR_OPERATION(Floor, hn::Floor(a...));
SELVAGE_VECTOR_OPERATION(Ceil, hn::Ceil(a...));
SELVAGE_VECTOR_OPERATION(AllFalse, hn::AllFalse(a...));
SELVAGE_VECTOR_OPERATION(NotAllFalse, !hn::AllFalse(a...));
SELVAGE_VECTOR_OPERATION(AllTrue, hn::AllTrue(a...));
SELVAGE_VECTOR_OPERATION(NotAllTrue, !hn::AllTrue(a...));
SELVAGE_VECTOR_OPERATION(IfThenElse, hn::IfThenElse(a...));
#undef SELVAGE_VECTOR_OPERATION

struct VectorLe {  // Highway has it for floating point only
  template <class V>
  static HWY_INLINE auto of(const V& a, const V& b) {
    return hn::Not(hn::Lt(b, a));
  }
};
struct VectorIfElseThen {
  template <class Mask, class V>
  static HWY_INLINE V of(const Mask& mask, const V& yes, const V& no) {
    return hn::IfThenElse(mask, no, yes);
  }
};

template <int kFirst, class Original, class Other, class... A>
HWY_INLINE auto vector_call(const A&... a) {
  mutants::note_that_it_applies<kFirst>();
  return mutants::chosen<kFirst>() == 1 ? Other::of(a...) : Original::of(a...);
}

// A shift by a constant: the other way, by one more, by one less.
template <int kFirst, int kBits, bool kLeft, class V>
HWY_INLINE V vector_shift(V v) {
  constexpr int kMostBits = static_cast<int>(sizeof(hn::TFromV<V>)) * 8 - 1;
  constexpr int kMore = kBits < kMostBits ? kBits + 1 : kBits, kLess = kBits > 0 ? kBits - 1 : 0;
  mutants::note_that_it_applies<kFirst>();
  if constexpr (kMore != kBits) mutants::note_that_it_applies<kFirst + 1>();
  if constexpr (kLess != kBits) mutants::note_that_it_applies<kFirst + 2>();
  const auto by = [&](auto bits) HWY_ATTR -> V {
    if constexpr (kLeft) return hn::ShiftLeft<decltype(bits)::value>(v);
    return hn::ShiftRight<decltype(bits)::value>(v);
  };
  switch (mutants::chosen<kFirst>()) {
    case 1:
      return kLeft ? hn::ShiftRight<kBits>(v) : hn::ShiftLeft<kBits>(v);
    case 2:
      return by(std::integral_constant<int, kMore>());
    case 3:
      return by(std::integral_constant<int, kLess>());
    default:
      return by(std::integral_constant<int, kBits>());
  }
}
