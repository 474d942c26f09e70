// From places in the texture to pixels, a vector at a time: at once, or ahead of a fetch that would
// wait for memory. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_FETCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_FETCH_INL_H
#undef SELVAGE_VECTOR_FETCH_INL_H
#else
#define SELVAGE_VECTOR_FETCH_INL_H
#endif

#include <cstring>

#include "mapper/vector/kernel-inl.h"
#include "mapper/vector/store-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

template <class Pixel>
[[nodiscard]] HWY_INLINE Pixel texel_at(const void* texels, int32_t place) {
  Pixel texel;
  std::memcpy(&texel, static_cast<const Pixel*>(texels) + place, sizeof(Pixel));
  return texel;
}

// By scalar loads, which were faster than gathers where both were measured, but for whole vectors
// of one kind of processor: are_gathers_fast().
template <class Pixel>
HWY_INLINE void fetch_as(const void* texels, const int32_t* HWY_RESTRICT place, int32_t count,
                         char* HWY_RESTRICT pixel) {
#pragma GCC unroll 4
  for (int32_t i = 0; i < count; ++i) {
    const Pixel texel = texel_at<Pixel>(texels, place[i]);
    std::memcpy(pixel + i * ptrdiff_t{sizeof(Pixel)}, &texel, sizeof(Pixel));
  }
}

// The same, of a whole vector.
template <class Pixel, int32_t kCount>
HWY_INLINE void fetch_as(const void* texels, const int32_t* HWY_RESTRICT place,
                         char* HWY_RESTRICT pixel) {
#pragma GCC unroll 16
  for (int32_t i = 0; i < kCount; ++i) {
    const Pixel texel = texel_at<Pixel>(texels, place[i]);
    std::memcpy(pixel + i * ptrdiff_t{sizeof(Pixel)}, &texel, sizeof(Pixel));
  }
}

// The first pixels of a vector, 0 or more. How many there are a processor seldom foresees: so there
// is no branch for it where vectors are made of scalars at little cost. Places of others may mean
// nothing.
template <class Pixel>
HWY_INLINE void fetch_first(const void* texels, V32 places, int32_t count, char* pixel) {
  const D32 d;
  HWY_ALIGN int32_t place[kLanes];
  hn::Store(hn::IfThenElseZero(hn::Lt(hn::Iota(d, 0), hn::Set(d, count)), places), d, place);
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4
  const auto at = [&](int32_t i) HWY_ATTR __attribute__((always_inline)) {
    return static_cast<int32_t>(texel_at<Pixel>(texels, place[i]));
  };
#if HWY_TARGET == HWY_AVX2
  const V32 first{_mm256_setr_epi32(at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7))};
#else
  const V32 first{_mm_setr_epi32(at(0), at(1), at(2), at(3))};
#endif
  store_first(first, count, reinterpret_cast<Pixel*>(pixel));
#else
  fetch_as<Pixel>(texels, place, count, pixel);
#endif
}

// Of a vector, or of the first ones.
template <class Pixel>
HWY_INLINE void fetch_vector(const void* texels, V32 places, int32_t count, char* pixel) {
  if (HWY_UNLIKELY(count < kLanes)) return fetch_first<Pixel>(texels, places, count, pixel);
  HWY_ALIGN int32_t place[kLanes];
  hn::Store(places, D32(), place);
  fetch_as<Pixel, kLanes>(texels, place, pixel);
}

// Draws vectors of texels of which no more is in doubt.
template <class Pixel, class Address>
class TexelFetch {
 public:
  explicit HWY_INLINE TexelFetch(const selvage_texture& texture)
      : texels_(texture.texels), extent_(extent_of(texture)) {}

  HWY_INLINE void draw(V32 s, V32 t, int32_t count_px, Pixel* to) const {
    fetch_vector<Pixel>(texels_, Address::place(s, t, extent_), count_px,
                        reinterpret_cast<char*>(to));
  }

 private:
  const void* texels_;
  Extent extent_;
};

// Calls draw(offset_px, count_px) for the vectors of a row, whole ones where it is wide enough: the
// last one may meet the one before.
template <class Draw>
HWY_INLINE void for_each_vector_of(const Span& span, const Draw& draw) {
  const int32_t width_px = span.width_px(), last_px = HWY_MAX(width_px - kLanes, 0);
  for (int32_t px = 0; px < width_px; px += kLanes) {
    const int32_t from_px = HWY_MIN(px, last_px);
    draw(from_px, width_px - from_px);
  }
}

// Texels are asked for so many pixels before they are fetched: what a processor draws in some
// hundred ns, which memory takes to answer. In lines of their own they fill 16 KB, half of a small
// first cache.
inline constexpr int32_t kFetchAhead_px = 256;

template <class Pixel>
class FetchAtOnce {
 public:
  explicit HWY_INLINE FetchAtOnce(const void* texels)
      : texels_(texels), gathers_(kMayGather && are_gathers_fast()) {}

  // Pixels are the first ones.
  HWY_INLINE void add(V32 places, int32_t count_px, char* pixels) {
    if (kMayGather && gathers_ && HWY_LIKELY(count_px >= kLanes)) return gather(places, pixels);
    fetch_vector<Pixel>(texels_, places, count_px, pixels);
  }
  HWY_INLINE void finish() {}

 private:
  static constexpr bool kMayGather = HWY_TARGET == HWY_AVX3 && sizeof(Pixel) == sizeof(int32_t);

  HWY_INLINE void gather(V32 places, char* pixels) const {
    const D32 d;
    const V32 texels = hn::GatherIndex(d, static_cast<const int32_t*>(texels_), places);
    hn::StoreU(texels, d, reinterpret_cast<int32_t*>(pixels));
  }

  const void* texels_;
  bool gathers_;
};

// A ring of vectors whose texels, those of all lanes, have been asked for: their places must be
// valid. Pixels are written once it is full, the oldest ones first, and all of them once it is
// finished.
template <class Pixel>
class FetchAhead {
 public:
  explicit HWY_INLINE FetchAhead(const void* texels) : texels_(static_cast<const char*>(texels)) {}

  HWY_INLINE void add(V32 places, int32_t count_px, char* pixels) {
    const size_t slot = fetch_oldest();
    hn::Store(places, D32(), place_[slot]);
    count_px_[slot] = count_px;
    pixels_[slot] = pixels;
#pragma GCC unroll 16
    for (int32_t i = 0; i < kLanes; ++i) {
      __builtin_prefetch(texels_ + place_[slot][i] * ptrdiff_t{sizeof(Pixel)});
    }
  }
  HWY_INLINE void finish() {
    for (size_t i = 0; i < kSlots; ++i) fetch_oldest();
  }

 private:
  static constexpr size_t kSlots = kFetchAhead_px / kLanes;

  // Returns its slot, which is free then.
  HWY_INLINE size_t fetch_oldest() {
    const size_t slot = oldest_;
    oldest_ = (slot + 1) % kSlots;
    const int32_t count_px = count_px_[slot];
    if (HWY_LIKELY(count_px >= kLanes)) {
      fetch_as<Pixel, kLanes>(texels_, place_[slot], pixels_[slot]);
    } else if (count_px > 0) {
      fetch_first<Pixel>(texels_, hn::Load(D32(), place_[slot]), count_px, pixels_[slot]);
    }
    return slot;
  }

  const char* texels_;
  size_t oldest_ = 0;
  HWY_ALIGN int32_t place_[kSlots][kLanes];
  int32_t count_px_[kSlots] = {};  // 0 where the slot is free
  char* pixels_[kSlots] = {};
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
