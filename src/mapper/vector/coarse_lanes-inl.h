// Lanes of both coordinates in 32 bits, for pixels whose texels lie in one window: half the work,
// and coarse. Included once for each SIMD target.
//
// Counted from the window's origin, u is the low half of the word and v the high one, and the
// highest bits of each are its texel. So a coordinate with n bits of texel is in units of 2^n fx16:
//
//     lane <= true value < lane + coarse_lack(n, lack_fx16) + 1       (spec/proofs/coarse_lanes.g)
//
// modulo 2^16, where the lack is not capped. A lane of the same texel as lane + coarse_lack shows
// it.
#if defined(SELVAGE_VECTOR_COARSE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_COARSE_LANES_INL_H
#undef SELVAGE_VECTOR_COARSE_LANES_INL_H
#else
#define SELVAGE_VECTOR_COARSE_LANES_INL_H
#endif

#include <bit>

#include "mapper/vector/lanes-inl.h"
#include "mapper/vector/words-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

using CoarseTag = hn::Repartition<uint16_t, D32>;
using CoarseVector = hn::Vec<CoarseTag>;

template <int kColumnBits, int32_t kRows>
class CoarseLanes {
  // Of a single row there is a bit, too, that near-ties change.
  static constexpr int kRowBits = std::bit_width(static_cast<uint32_t>(HWY_MAX(kRows, 2) - 1));
  static_assert(kColumnBits <= kMostCoarseTexelBits && kRowBits <= kMostCoarseTexelBits);

 public:
  // A true value is not below anchor + offset, and below anchor + offset + lack_fx16.
  HWY_INLINE CoarseLanes(const LaneVectors& offsets_fx16, int32_t lack_fx16)
      : offsets_(hn::BitCast(CoarseTag(), pack(offsets_fx16))),
        beyond_(hn::Add(
            offsets_, both(coarse_lack(kColumnBits, lack_fx16), coarse_lack(kRowBits, lack_fx16)))),
        texel_units_(both(1 << kColumnBits, 1 << kRowBits)),
        weights_(hn::BitCast(hn::RebindToSigned<CoarseTag>(), both(1, 1 << kColumnBits))) {}

  // Of anchors or of offsets, modulo 2^32 as those are.
  [[nodiscard]] static HWY_INLINE V32 pack(const LaneVectors& lanes_fx16) {
    return hn::IfVecThenElse(hn::Set(D32(), 0xFFFF), hn::ShiftRight<kColumnBits>(lanes_fx16.u),
                             hn::ShiftLeft<kCoarseBits - kRowBits>(lanes_fx16.v));
  }

  // Of a vector: indices in the window, a row after another, and what all that its lanes may lack
  // changes in them.
  struct Texels {
    V32 index, changes;
  };
  [[nodiscard]] HWY_INLINE Texels texels(int32_t anchor) const {
    const D32 d;
    const auto from = hn::BitCast(CoarseTag(), hn::Set(d, anchor));
    const auto lanes = hn::Add(from, offsets_);
    const auto changes = hn::Xor(lanes, hn::Add(from, beyond_));
    const auto texels =
        hn::BitCast(hn::RebindToSigned<CoarseTag>(), hn::MulHigh(lanes, texel_units_));
    return {word_products(texels, weights_), hn::BitCast(d, changes)};
  }
  // Whether some index may be that of the texel before.
  [[nodiscard]] static HWY_INLINE bool any_near(V32 changes) {
    return any_bits(changes, kTexelMask);
  }

 private:
  static constexpr int32_t kTexelMask =
      static_cast<int32_t>((~uint32_t{0} << (2 * kCoarseBits - kRowBits)) |
                           ((0xFFFFU << (kCoarseBits - kColumnBits)) & 0xFFFFU));

  static HWY_INLINE CoarseVector both(int32_t u, int32_t v) {
    const uint32_t high = static_cast<uint32_t>(v) << kCoarseBits;
    return hn::BitCast(CoarseTag(),
                       hn::Set(D32(), static_cast<int32_t>(high | static_cast<uint32_t>(u))));
  }

  CoarseVector offsets_, beyond_, texel_units_;
  hn::Vec<hn::RebindToSigned<CoarseTag>> weights_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
