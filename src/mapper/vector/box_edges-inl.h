// The windows that boxes are summed in, and what is beyond the texture's edges. Included once for
// each SIMD target.
#if defined(SELVAGE_VECTOR_BOX_EDGES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BOX_EDGES_INL_H
#undef SELVAGE_VECTOR_BOX_EDGES_INL_H
#else
#define SELVAGE_VECTOR_BOX_EDGES_INL_H
#endif

#include "mapper/box_side.h"
#include "mapper/filter_point.h"
#include "mapper/vector/kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Columns are summed a window at a time: 4 or 8 texels.
using DBytes = hn::CappedTag<uint8_t, 32>;
using DWords = hn::Repartition<int16_t, DBytes>;
using DSums = hn::Repartition<int32_t, DBytes>;
using VBytes = hn::Vec<DBytes>;
using VWords = hn::Vec<DWords>;
using VSums = hn::Vec<DSums>;
inline constexpr int32_t kBoxWindow_texel = static_cast<int32_t>(hn::MaxLanes(DSums()));

// What a texel of a window stands for, from its left border on: of a box that begins or ends in it.
struct Reach {
  VSums least_fx8, most_fx8;
};
struct NoEdge {
  static HWY_INLINE int32_t row(int32_t t, int32_t /*height_texel*/) { return t; }
  static HWY_INLINE Reach reach(VSums /*texel*/, int32_t /*width_texel*/) {
    const DSums d;
    return {hn::Zero(d), hn::Set(d, kTexel_fx8)};
  }
};

// The outermost texels stand for all that is beyond them.
struct ClampEdge {
  static HWY_INLINE int32_t start(int32_t begin_fx8, int32_t /*size_texel*/) { return begin_fx8; }
  static HWY_INLINE bool fits(const BoxSide& /*columns*/, const BoxSide& /*rows*/,
                              const selvage_texture& /*texture*/) {
    return true;
  }
  static HWY_INLINE int32_t row(int32_t t, int32_t height_texel) {
    return HWY_MIN(HWY_MAX(t, 0), height_texel - 1);
  }
  static HWY_INLINE Reach reach(VSums texel, int32_t width_texel) {
    const DSums d;
    constexpr int32_t kFar_fx8 = 1 << 26;
    const VSums none = hn::Zero(d), one = hn::Set(d, kTexel_fx8);
    const VSums last = hn::Set(d, width_texel - 1);
    const VSums most = hn::IfThenElse(hn::Eq(texel, last), hn::Set(d, kFar_fx8), one);
    return {hn::IfThenElse(hn::Eq(texel, none), hn::Set(d, -kFar_fx8), none),
            hn::IfThenElse(hn::Gt(texel, last), none, most)};
  }
};

// Boxes start in the first period; rows may go on in the second, columns are left to others there.
struct WrapEdge : NoEdge {
  static HWY_INLINE int32_t start(int32_t begin_fx8, int32_t size_texel) {
    return in_first_period(begin_fx8, size_texel);
  }
  static HWY_INLINE bool fits(const BoxSide& columns, const BoxSide& rows,
                              const selvage_texture& texture) {
    return columns.is_inside(texture.width) && rows.texels <= texture.height;
  }
  static HWY_INLINE int32_t row(int32_t t, int32_t height_texel) {
    return t < height_texel ? t : t - height_texel;
  }
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
