// Pairs of texels side by side, loaded into vectors. Included once for each SIMD target.
//
// From memory to registers at once: what is stored in small pieces and loaded as a vector waits for
// the stores.
#if defined(SELVAGE_VECTOR_BLEND_PAIRS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BLEND_PAIRS_INL_H
#undef SELVAGE_VECTOR_BLEND_PAIRS_INL_H
#else
#define SELVAGE_VECTOR_BLEND_PAIRS_INL_H
#endif

#include <bit>
#include <cstring>

#include "mapper/vector/kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

inline constexpr ptrdiff_t kTexelBytes = sizeof(uint32_t);
static_assert(std::endian::native == std::endian::little, "the left texel is a pair's low half");

using D64 = hn::Repartition<uint64_t, D32>;
using DBlock = hn::Full128<uint64_t>;
using Block = hn::Vec<DBlock>;

// A pixel's pair is 64 bits, and a block of 128 bits has four pixels. So the pairs of a vector of
// pixels fill two: of the first and second pixel of each block, of the third and fourth.
struct Pairs {
  V32 first, last;
};

[[nodiscard]] HWY_INLINE Block block_of(uint64_t low, uint64_t high) {
  const hn::Half<DBlock> half;
  return hn::Combine(DBlock(), hn::Set(half, high), hn::Set(half, low));
}

[[nodiscard]] HWY_INLINE Block load_block(const char* low, const char* high) {
#if HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
  const __m128i one = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(low));
  const __m128 both = _mm_loadh_pi(_mm_castsi128_ps(one), reinterpret_cast<const __m64*>(high));
  return Block{_mm_castps_si128(both)};
#else
  uint64_t first, second;
  std::memcpy(&first, low, sizeof first);
  std::memcpy(&second, high, sizeof second);
  return block_of(first, second);
#endif
}

[[nodiscard]] HWY_INLINE uint64_t load_pair(const char* left, const char* right) {
  uint32_t first, second;
  std::memcpy(&first, left, sizeof first);
  std::memcpy(&second, right, sizeof second);
  return uint64_t{second} << 32 | first;
}

// Highway's Combine clears first what it then overwrites.
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
[[nodiscard]] HWY_INLINE hn::Vec256<uint64_t> join(Block low, Block high) {
  return hn::Vec256<uint64_t>{
      _mm256_inserti128_si256(_mm256_castsi128_si256(low.raw), high.raw, 1)};
}
#endif
#if HWY_TARGET == HWY_AVX3
[[nodiscard]] HWY_INLINE hn::Vec512<uint64_t> join(hn::Vec256<uint64_t> low,
                                                   hn::Vec256<uint64_t> high) {
  return hn::Vec512<uint64_t>{_mm512_inserti64x4(_mm512_castsi256_si512(low.raw), high.raw, 1)};
}
#endif

// The pairs around pixels: in the upper row and in the lower one.
template <class Vector>
struct Around {
  Vector upper, lower;
};

// From `pixel` on, where around(i) has those of pixels i and i + 1.
template <class D, class AroundTwo>
[[nodiscard]] HWY_INLINE Around<hn::Vec<D>> gather_blocks(D d, int32_t pixel,
                                                          const AroundTwo& around) {
  constexpr int32_t kPairs = static_cast<int32_t>(hn::MaxLanes(d));
  if constexpr (kPairs == 2) {
    return around(pixel);
  } else {
    const hn::Half<D> half;
    const auto low = gather_blocks(half, pixel, around);
    const auto high = gather_blocks(half, pixel + kPairs, around);
    return {join(low.upper, high.upper), join(low.lower, high.lower)};
  }
}

template <class AroundTwo>
[[nodiscard]] HWY_INLINE Around<Pairs> gather(const AroundTwo& around) {
  const D32 d;
  const auto first = gather_blocks(D64(), 0, around), last = gather_blocks(D64(), 2, around);
  return {{hn::BitCast(d, first.upper), hn::BitCast(d, last.upper)},
          {hn::BitCast(d, first.lower), hn::BitCast(d, last.lower)}};
}

// Where texels are, in texels from the lowest in memory: 32 bits without a sign. They go through
// memory, for taking a vector apart costs more than loading its lanes.
class Places {
 public:
  HWY_INLINE explicit Places(V32 places) { hn::Store(places, D32(), place_); }
  HWY_INLINE ptrdiff_t bytes(int32_t i) const {
    const volatile uint32_t* const place = reinterpret_cast<const volatile uint32_t*>(place_) + i;
    return ptrdiff_t{*place} * kTexelBytes;
  }

 private:
  HWY_ALIGN int32_t place_[kLanes];
};

// What rows of negative pitch count from.
struct LowestRow {
  const char* texels;
  int32_t first_texel;  // the place of the texture's first

  explicit LowestRow(const selvage_texture& texture)
      : texels(static_cast<const char*>(texture.texels)), first_texel(0) {
    if (texture.pitch >= 0) return;
    const ptrdiff_t below = (texture.height - 1) * -texture.pitch;
    texels -= below;
    first_texel = static_cast<int32_t>(below / kTexelBytes);
  }
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
