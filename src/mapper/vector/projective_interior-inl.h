// Which batches in perspective surely show texels of the texture, whatever the address mode.
// Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_PROJECTIVE_INTERIOR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PROJECTIVE_INTERIOR_INL_H
#undef SELVAGE_VECTOR_PROJECTIVE_INTERIOR_INL_H
#else
#define SELVAGE_VECTOR_PROJECTIVE_INTERIOR_INL_H
#endif

#include "mapper/interior.h"
#include "mapper/vector/projective_anchors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Whether the texels that all pixels of a batch show, near-ties among them, lie in the texture. u
// and v are monotone along a span: its ends have the least and the most.
[[nodiscard]] HWY_NOINLINE bool is_inside(const SpanBatch& batch, const ProjectiveField& field,
                                          const AnchoredVectors& vectors,
                                          const selvage_texture& texture) {
  const DHalf half;
  const DD d;
  const VD error = hn::Set(d, static_cast<double>(field.error_fx32) * kFx16PerFx32);
  const auto is_outside = [&](VD value_fx16, int32_t size_texel) HWY_ATTR {
    const double end_fx16 = static_cast<double>(size_texel) * (1 << kTexelFraction);
    return hn::Or(hn::Lt(value_fx16, error),
                  hn::Ge(hn::Add(value_fx16, error), hn::Set(d, end_fx16)));
  };
  const auto outside = [&](VHalf px, VHalf row) HWY_ATTR {
    const auto at = vectors.estimates(px, row);
    return hn::Or(is_outside(at.u_fx16, texture.width), is_outside(at.v_fx16, texture.height));
  };
  for (int32_t i = 0; i < batch.rows; i += kDoubles) {
    const VHalf left_px = hn::LoadU(half, batch.left_px.data() + i);
    const VHalf right_px = hn::LoadU(half, batch.right_px.data() + i);
    const VHalf row = hn::Iota(half, batch.first_row + i);
    const auto any =
        hn::Or(outside(left_px, row), outside(hn::Sub(right_px, hn::Set(half, 1)), row));
    const auto is_row = hn::Lt(hn::Iota(d, i), hn::Set(d, static_cast<double>(batch.rows)));
    const auto has_pixels = hn::Lt(hn::PromoteTo(d, left_px), hn::PromoteTo(d, right_px));
    if (!hn::AllFalse(d, hn::And(any, hn::And(is_row, has_pixels)))) return false;
  }
  return true;
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
