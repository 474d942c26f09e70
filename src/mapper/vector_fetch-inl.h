// From places in the texture to pixels, a vector at a time: at once, or ahead of a fetch that would
// wait for memory. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_FETCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_FETCH_INL_H
#undef SELVAGE_VECTOR_FETCH_INL_H
#else
#define SELVAGE_VECTOR_FETCH_INL_H
#endif

#include "mapper/vector_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Texels are asked for so many pixels before they are fetched: what a processor draws in some
// hundred ns, which memory takes to answer. In lines of their own they fill 16 KB, half of a small
// first cache.
inline constexpr int32_t kFetchAhead_px = 256;

template <class Pixel>
class FetchAtOnce {
 public:
  explicit HWY_INLINE FetchAtOnce(const void* texels) : texels_(texels) {}

  // Pixels are the first ones.
  HWY_INLINE void add(V32 places, int32_t count_px, char* pixels) {
    HWY_ALIGN int32_t place[kLanes];
    hn::Store(places, D32(), place);
    fetch_vector<Pixel>(texels_, place, count_px, pixels);
  }
  HWY_INLINE void finish() {}

 private:
  const void* texels_;
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
    fetch_vector<Pixel>(texels_, place_[slot], count_px_[slot], pixels_[slot]);
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
