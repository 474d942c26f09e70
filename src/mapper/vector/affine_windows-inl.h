// Affine spans by windows, those of some vectors found at once. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_WINDOWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_WINDOWS_INL_H
#undef SELVAGE_VECTOR_AFFINE_WINDOWS_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_WINDOWS_INL_H
#endif

#include "mapper/interior.h"
#include "mapper/vector/affine_lanes-inl.h"
#include "mapper/vector/coarse_lanes-inl.h"
#include "mapper/vector/one_window-inl.h"
#include "mapper/vector/store-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Vectors of pixels: the lanes of their anchors, counted from the origins of their windows, and the
// places of those, kNoPlace where there is none.
struct FoundWindows {
  static constexpr int32_t kMost = kRowsPerBatch;
  // With room for a vector that begins at the last one.
  HWY_ALIGN int32_t u_fx16[kMost + kLanes], v_fx16[kMost + kLanes];
  HWY_ALIGN int32_t coarse[kMost + kLanes];  // both, as CoarseLanes has them
  HWY_ALIGN int32_t place[kMost + kLanes];
};

// Whether all pixels surely show texels of the texture, whatever the address mode: as the box of
// the polygon's corners tells, or the batch's own pixels.
[[nodiscard]] HWY_INLINE bool shows_texture_alone(const AffineSpans& spans,
                                                  const selvage_texture& texture) {
  return TexelRanges(spans.texels).within(texture) ||
         (pays_to_ask_inside(spans.batch) && is_inside(spans.batch, spans.field, texture));
}

// How a texture is addressed, told at run time: windows are found so seldom that one loop is for
// all modes.
enum class Addressing { kClamped, kMasked, kWrapped };

[[nodiscard]] HWY_INLINE Addressing addressing_of(const Surface& surface) {
  if (surface.address == SELVAGE_ADDRESS_CLAMP) return Addressing::kClamped;
  const bool masked =
      WrapMasked::fits(surface.texture.width) && WrapMasked::fits(surface.texture.height);
  return masked ? Addressing::kMasked : Addressing::kWrapped;
}

// Finds windows of one shape, kLanes at a time, by the anchors of their vectors.
template <class Coarse>
class WindowFinder {
 public:
  HWY_INLINE WindowFinder(const Surface& surface, const WindowShape& shape, bool inside)
      : extent_(extent_of(surface.texture)),
        shape_(shape),
        addressing_(inside ? Addressing::kClamped : addressing_of(surface)) {}

  // The k-th ones from there on.
  HWY_INLINE void find(const WideLanes& anchor_u, const WideLanes& anchor_v, int32_t k,
                       FoundWindows* found) const {
    const D32 d;
    const auto from = [&](const WideLanes& anchor, V32 texel, V32 origin) HWY_ATTR {
      return hn::Or(hn::ShiftLeft<kTexelFraction>(hn::Sub(texel, origin)), anchor.fractions_fx16());
    };
    const V32 s = anchor_u.texels(), t = anchor_v.texels();
    const WindowOrigins<V32> origins = origins_of(s, t);
    const V32 u = from(anchor_u, s, origins.s), v = from(anchor_v, t, origins.t);
    hn::StoreU(u, d, found->u_fx16 + k);
    hn::StoreU(v, d, found->v_fx16 + k);
    hn::StoreU(Coarse::pack({u, v}), d, found->coarse + k);
    hn::StoreU(origins.place, d, found->place + k);
  }

 private:
  HWY_INLINE WindowOrigins<V32> origins_of(V32 s, V32 t) const {
    const V32 columns = hn::Set(D32(), 1 << shape_.column_bits), rows = hn::Set(D32(), shape_.rows);
    switch (addressing_) {
      case Addressing::kMasked:
        return window_origins<WrapMaskedVector>(s, t, columns, rows, extent_);
      case Addressing::kWrapped:
        return window_origins<WrapVector>(s, t, columns, rows, extent_);
      default:
        return window_origins<ClampVector>(s, t, columns, rows, extent_);
    }
  }

  Extent extent_;
  WindowShape shape_;
  Addressing addressing_;
};

// Draws vectors by windows of one shape; kRows is 0 for any number of rows.
template <class Pixel, class InWindow, int kColumnBits, int32_t kRows>
class WindowDraw {
 public:
  using Coarse = CoarseLanes<kColumnBits, kRows == 0 ? kMostWindowRows : kRows>;

  HWY_INLINE WindowDraw(const AffineSpans& spans, const Surface& surface, int32_t rows)
      : batch_(spans, surface),
        coarse_(batch_.offsets(), batch_.lack_fx16()),
        texels_(static_cast<const Pixel*>(surface.texture.texels)),
        pitch_texel_(pitch_texel_of(surface.texture)),
        rows_(rows) {}

  // False where a pixel may be a near-tie, or there is no window.
  HWY_INLINE bool draw(const FoundWindows& found, int32_t k, int32_t count_px, Pixel* to) const {
    const int32_t rows = kRows == 0 ? rows_ : kRows;
    const int32_t place = found.place[k];
    if (HWY_UNLIKELY(place == kNoPlace)) return false;
    auto [index, changes] = coarse_.texels(found.coarse[k]);
    if (InWindow::kClampsWindows || HWY_UNLIKELY(Coarse::any_near(changes))) {
      const LaneVectors lanes = batch_.lanes_from(found.u_fx16[k], found.v_fx16[k]);
      if (HWY_UNLIKELY(batch_.any_near(lanes))) return false;
      index = batch_.template window_index<kColumnBits>(lanes, rows);
    }
    store_pixels(pick<kColumnBits>(texels_ + place, pitch_texel_, rows, index), count_px, to);
    return true;
  }
  HWY_INLINE Lane to_anchor() const { return batch_.to_anchor(); }

 private:
  AffineBatch<InWindow> batch_;
  Coarse coarse_;
  const Pixel* texels_;
  ptrdiff_t pitch_texel_;
  int32_t rows_;
};

// Calls by.template draw<Pixel, InWindow, kColumnBits, kRows>(shape) as windows of this shape are
// drawn from. `inside`: the texture holds all texels.
template <class Pixel, class By>
HWY_INLINE void with_window_shape(const Surface& surface, const WindowShape& shape, bool inside,
                                  const By& by) {
  using Inside = Addressed<InsideVector>;
  constexpr int kBits = kWindowColumnBits;
  constexpr int32_t kOne = kRowsPerPermute, kTwo = 2 * kOne, kThree = 3 * kOne, kFour = 4 * kOne;
  constexpr int32_t kMost = kMostWindowRows;
  static_assert(kMost == kThree || kMost == kFour + kOne, "these are all");
  if (surface.address == SELVAGE_ADDRESS_CLAMP && !inside) {
    by.template draw<Pixel, Addressed<ClampVector>, kBits, 0>({kBits, shape.rows});
  } else if (shape.is_half()) {
    by.template draw<Pixel, Inside, kHalfColumnBits, kHalfWindowRows>(shape);
  } else if (shape.rows == kOne) {
    by.template draw<Pixel, Inside, kBits, kOne>(shape);
  } else if (shape.rows == kTwo) {
    by.template draw<Pixel, Inside, kBits, kTwo>(shape);
  } else if (kThree < kMost && shape.rows == kThree) {
    by.template draw<Pixel, Inside, kBits, HWY_MIN(kThree, kMost)>(shape);
  } else if (kFour < kMost && shape.rows == kFour) {
    by.template draw<Pixel, Inside, kBits, HWY_MIN(kFour, kMost)>(shape);
  } else {
    by.template draw<Pixel, Inside, kBits, kMost>(shape);
  }
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
