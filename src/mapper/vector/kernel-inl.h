// What the vector kernels share: address modes, and from places in the texture to pixels.
// Included once for each SIMD target; Highway's toggle is the guard.
#if defined(SELVAGE_VECTOR_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_KERNEL_INL_H
#undef SELVAGE_VECTOR_KERNEL_INL_H
#else
#define SELVAGE_VECTOR_KERNEL_INL_H
#endif

#include <hwy/highway.h>

#include "mapper/address.h"
#include "mapper/exact_row.h"
#include "mapper/kernel.h"
#include "mapper/layout.h"
#include "mapper/vector/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using D32 = hn::CappedTag<int32_t, kMostLanes>;
using V32 = hn::Vec<D32>;
inline constexpr int32_t kLanes = static_cast<int32_t>(hn::MaxLanes(D32()));

// Where a run of texels begins: not yet addressed, and in the texture.
struct Origin {
  int32_t texel, index;
};
template <class V>
struct Origins {
  V texel, index;
};

// ---- Address modes: texel indices to indices into the texture ----------------------------------

struct ClampVector {
  using Scalar = Clamp;
  static constexpr bool kClampsWindows = true;
  template <class V>
  static HWY_INLINE V index(V texel, int32_t size_texel) {
    const hn::DFromV<V> d;
    return hn::Min(hn::Max(texel, hn::Zero(d)), hn::Set(d, size_texel - 1));
  }
  // Of a run that fits where it begins at `last` or before.
  static HWY_INLINE Origin origin(int32_t texel, int32_t last, int32_t /*size_texel*/) {
    const int32_t inside = HWY_MIN(HWY_MAX(texel, 0), last);
    return {inside, inside};
  }
  template <class V>
  static HWY_INLINE Origins<V> origins(V texel, V last, int32_t /*size_texel*/) {
    const V inside = hn::Min(hn::Max(texel, hn::Zero(hn::DFromV<V>())), last);
    return {inside, inside};
  }
  template <class V>
  static HWY_INLINE V window_texel(V texel, int32_t size_texel) {
    return index(texel, size_texel);
  }
};

// Of texels that are known to lie in the texture. A run may begin outside all the same, where its
// first ones are shown by no pixel.
struct InsideVector : ClampVector {
  static constexpr bool kClampsWindows = false;
  template <class V>
  static HWY_INLINE V index(V texel, int32_t /*size_texel*/) {
    return texel;
  }
  template <class V>
  static HWY_INLINE V window_texel(V texel, int32_t /*size_texel*/) {
    return texel;
  }
};

// A run keeps the texels that it asks for, and only where it begins is brought into the texture.
template <class Address, class ScalarAddress>
struct Wrapping {
  using Scalar = ScalarAddress;
  static constexpr bool kClampsWindows = false;
  static HWY_INLINE Origin origin(int32_t texel, int32_t /*last*/, int32_t size_texel) {
    return {texel, Scalar::index(texel, size_texel)};
  }
  template <class V>
  static HWY_INLINE Origins<V> origins(V texel, V /*last*/, int32_t size_texel) {
    return {texel, Address::index(texel, size_texel)};
  }
  template <class V>
  static HWY_INLINE V window_texel(V texel, int32_t /*size_texel*/) {
    return texel;
  }
};

struct WrapMaskedVector : Wrapping<WrapMaskedVector, WrapMasked> {
  template <class V>
  static HWY_INLINE V index(V texel, int32_t size_texel) {
    return hn::And(texel, hn::Set(hn::DFromV<V>(), size_texel - 1));
  }
};

// |texel| <= 2^23: roundings move a quotient by less than 1 / size, which is what it lacks of the
// next whole number at least, so that its floor is never too high, and too low by one at most.
struct WrapVector : Wrapping<WrapVector, Wrap> {
  template <class V>
  static HWY_INLINE V index(V texel, int32_t size_texel) {
    const hn::DFromV<V> d;
    const hn::RebindToFloat<decltype(d)> df;
    const auto reciprocal = hn::Set(df, 1.0F / static_cast<float>(size_texel));
    const V quotient = hn::ConvertTo(d, hn::Floor(hn::Mul(hn::ConvertTo(df, texel), reciprocal)));
    const V size = hn::Set(d, size_texel);
    const V rest = hn::Sub(texel, hn::Mul(quotient, size));
    return hn::IfThenElse(hn::Lt(rest, size), rest, hn::Sub(rest, size));
  }
};

// ---- Layouts: indices into the texture to places, in texels from its first ---------------------

struct RowsVector {
  template <class V>
  static HWY_INLINE V row(V t, int32_t pitch_texel) {
    return hn::Mul(t, hn::Set(hn::DFromV<V>(), pitch_texel));
  }
  template <class V>
  static HWY_INLINE V column(V s) {
    return s;
  }
};

struct TilesVector {
  template <class V>
  static HWY_INLINE V row(V t, int32_t pitch_texel) {
    const hn::DFromV<V> d;
    const V in_tile = hn::And(t, hn::Set(d, Tiles::kInTile));
    return hn::Add(hn::Mul(hn::ShiftRight<kTileBits>(t), hn::Set(d, pitch_texel)),
                   hn::ShiftLeft<kTileBits>(in_tile));
  }
  template <class V>
  static HWY_INLINE V column(V s) {
    const V in_tile = hn::And(s, hn::Set(hn::DFromV<V>(), Tiles::kInTile));
    return hn::Add(hn::ShiftLeft<kTileBits>(hn::Sub(s, in_tile)), in_tile);
  }
};

struct Extent {
  int32_t width_texel, height_texel, pitch_texel;
  bool tiled;
};

// An address mode, and whichever layout: from texel indices to places. The layout is asked for
// again and again, which costs little, so that there is one kernel for both.
template <class Mode>
struct Addressed : Mode {
  template <class V>
  static HWY_INLINE V row(V t, const Extent& extent) {
    const V inside = Mode::index(t, extent.height_texel);
    return HWY_UNLIKELY(extent.tiled) ? TilesVector::row(inside, extent.pitch_texel)
                                      : RowsVector::row(inside, extent.pitch_texel);
  }
  template <class V>
  static HWY_INLINE V column(V s, const Extent& extent) {
    const V inside = Mode::index(s, extent.width_texel);
    return HWY_UNLIKELY(extent.tiled) ? TilesVector::column(inside) : RowsVector::column(inside);
  }
  template <class V>
  static HWY_INLINE V place(V s, V t, const Extent& extent) {
    return hn::Add(row(t, extent), column(s, extent));
  }
};

// Calls draw with the address mode that fits.
template <class Draw>
HWY_INLINE void with_address(const Surface& surface, const Draw& draw) {
  const selvage_texture& texture = surface.texture;
  if (surface.address == SELVAGE_ADDRESS_CLAMP) return draw(Addressed<ClampVector>());
  if (WrapMasked::fits(texture.width) && WrapMasked::fits(texture.height)) {
    return draw(Addressed<WrapMaskedVector>());
  }
  return draw(Addressed<WrapVector>());
}

// Calls draw with a value of the pixel's type.
template <class Draw>
HWY_INLINE void with_pixel(selvage_format format, const Draw& draw) {
  if (format == SELVAGE_RGBA8888) return draw(uint32_t{});
  return format == SELVAGE_RGB565 ? draw(uint16_t{}) : draw(uint8_t{});
}

// Whether some lane has some of these bits.
[[nodiscard]] HWY_INLINE bool any_bits(V32 lanes, int32_t bits) {
  const V32 asked = hn::Set(D32(), bits);
#if HWY_TARGET == HWY_AVX2
  return _mm256_testz_si256(lanes.raw, asked.raw) == 0;
#elif HWY_TARGET == HWY_SSE4
  return _mm_testz_si128(lanes.raw, asked.raw) == 0;
#else
  return !hn::AllFalse(D32(), hn::TestBit(lanes, asked));
#endif
}

// A bit for each lane, the first one lowest.
[[nodiscard]] HWY_INLINE uint64_t bits_of(hn::Mask<D32> mask) {
#if HWY_TARGET == HWY_AVX3
  return mask.raw;
#else
  static_assert(kLanes <= 8);
  uint8_t bits[8];  // up to so many may be stored
  hn::StoreMaskBits(D32(), mask, bits);
  return bits[0];
#endif
}

// ---- Texels to pixels --------------------------------------------------------------------------

[[nodiscard]] HWY_INLINE Extent extent_of(const selvage_texture& texture) {
  return {texture.width, texture.height, static_cast<int32_t>(pitch_texel_of(texture)),
          texture.layout == SELVAGE_LAYOUT_TILES};
}

[[nodiscard]] HWY_INLINE char* first_pixel(const Surface& surface, const Span& span) {
  return static_cast<char*>(surface.target.pixels) + span.row * surface.target.pitch +
         span.left_px * bytes_per_pixel(surface.target.format);
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
