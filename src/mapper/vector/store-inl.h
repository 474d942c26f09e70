// From vectors of texels to pixels. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_STORE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_STORE_INL_H
#undef SELVAGE_VECTOR_STORE_INL_H
#else
#define SELVAGE_VECTOR_STORE_INL_H
#endif

#include "mapper/vector/kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

template <class Pixel>
using Pixels = hn::Vec<hn::Rebind<Pixel, D32>>;

template <class Pixel>
[[nodiscard]] HWY_INLINE Pixels<Pixel> as_pixels(V32 texels) {
  const hn::Rebind<Pixel, D32> d;
  if constexpr (sizeof(Pixel) == sizeof(int32_t)) {
    return hn::BitCast(d, texels);
  } else {
    return hn::TruncateTo(d, hn::BitCast(hn::RebindToUnsigned<D32>(), texels));
  }
}

// Whether vectors are stored in part by a mask. AVX2 has masks for 32-bit pixels, too, but with
// them a store takes as long as a dozen others on AMD Zen 3 (14 cycles).
inline constexpr bool kHasMask = HWY_TARGET <= HWY_AVX3;

// Where pieces of a row go: there, or nowhere if the row has fewer pixels. Told without a branch,
// which would seldom be foreseen.
template <class Pixel>
class PiecePlaces {
 public:
  HWY_INLINE PiecePlaces(Pixel* to, Pixel* nowhere, int32_t count)
      : nowhere_(address(nowhere)), away_(address(to) ^ nowhere_), count_(count) {}

  [[nodiscard]] HWY_INLINE Pixel* of(int32_t piece_px) const {
    const auto fewer = static_cast<uintptr_t>((count_ - piece_px) >> 63);
    return reinterpret_cast<Pixel*>(nowhere_ ^ (away_ & ~fewer));
  }

 private:
  static HWY_INLINE uintptr_t address(const Pixel* at) { return reinterpret_cast<uintptr_t>(at); }

  uintptr_t nowhere_, away_;
  int64_t count_;
};

// The last four and the last one of the first pixels of a vector; where it has fewer, any pixels.
template <class Pixel>
struct LastPixels {
  hn::Vec<hn::CappedTag<Pixel, 4>> four;
  Pixel one;
};

template <class Pixel>
[[nodiscard]] HWY_INLINE LastPixels<Pixel> last_pixels(Pixels<Pixel> pixels, int32_t count) {
  const hn::CappedTag<Pixel, 4> d4;
#if HWY_TARGET == HWY_AVX2
  if constexpr (sizeof(Pixel) == sizeof(int32_t)) {
    const V32 lane = hn::Add(hn::Iota(D32(), 0), hn::Set(D32(), count - 4));
    const auto four =
        hn::LowerHalf(d4, Pixels<Pixel>{_mm256_permutevar8x32_epi32(pixels.raw, lane.raw)});
    return {four, hn::ExtractLane(four, 3)};
  }
#endif
  HWY_ALIGN Pixel row[kLanes];
  hn::Store(pixels, hn::Rebind<Pixel, D32>(), row);
  return {hn::LoadU(d4, row + HWY_MAX(count - 4, 0)), row[(count - 1) & (kLanes - 1)]};
}

// Stores the first pixels of a vector, 0 to kLanes of them, by pieces that may meet.
template <class Pixel>
HWY_INLINE void store_pieces(Pixels<Pixel> pixels, int32_t count, Pixel* to) {
  const hn::CappedTag<Pixel, 4> d4;
  const hn::CappedTag<Pixel, 2> d2;
  HWY_ALIGN Pixel nowhere[8];
  const PiecePlaces<Pixel> places(to, nowhere + 4, count);
  const LastPixels<Pixel> last = last_pixels<Pixel>(pixels, count);
  if constexpr (kLanes == 8) {
    hn::StoreU(hn::LowerHalf(d4, pixels), d4, places.of(4));
    hn::StoreU(last.four, d4, places.of(4) + (count - 4));
    hn::StoreU(hn::LowerHalf(d2, hn::LowerHalf(d4, pixels)), d2, places.of(2));
  } else {
    hn::StoreU(pixels, d4, places.of(4));
    hn::StoreU(hn::LowerHalf(d2, pixels), d2, places.of(2));
  }
  places.of(1)[count - 1] = last.one;
}

// Stores the first `count` pixels of a vector, 0 or more, and all where it has fewer. For vectors
// that are now whole and now not.
template <class Pixel>
HWY_INLINE void store_first(V32 texels, int32_t count, Pixel* to) {
  const auto pixels = as_pixels<Pixel>(texels);
  if constexpr (kHasMask) {
    const hn::Rebind<Pixel, D32> d;
    hn::BlendedStore(pixels, hn::FirstN(d, static_cast<size_t>(count)), d, to);
  } else {
    store_pieces<Pixel>(pixels, HWY_MIN(count, kLanes), to);
  }
}

// The same, for vectors that are whole but for a few.
template <class Pixel>
HWY_INLINE void store_pixels(V32 texels, int32_t count, Pixel* to) {
  if (HWY_LIKELY(count >= kLanes)) {
    return hn::StoreU(as_pixels<Pixel>(texels), hn::Rebind<Pixel, D32>(), to);
  }
  store_first(texels, count, to);
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
