// Small polygons row by row: each from one window, or by a load for each pixel. Where there is a
// near-tie the polygon is drawn once more. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_SMALL_WINDOWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_SMALL_WINDOWS_INL_H
#undef SELVAGE_VECTOR_SMALL_WINDOWS_INL_H
#else
#define SELVAGE_VECTOR_SMALL_WINDOWS_INL_H
#endif

#include "mapper/vector/affine_window-inl.h"
#include "mapper/vector/fetch-inl.h"
#include "mapper/vector/small_set_up-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_AVX3

static_assert(kSmall.most_px == kLanes, "a row is a vector, all are one");

// Of each row: its first pixel, how many there are, and the lanes from the first on.
template <class Kind>
class SmallRows {
 public:
  HWY_INLINE SmallRows(const SmallSetUp<Kind>& set_up, size_t i, int32_t first_px, int32_t end_px)
      : SmallRows(set_up, i, first_px, SmallSpans(set_up.edges.of(i), 0, first_px, end_px)) {}

  HWY_ALIGN int32_t left_px[kLanes], count_px[kLanes];
  typename Kind::Rows lanes;

 private:
  HWY_INLINE SmallRows(const SmallSetUp<Kind>& set_up, size_t i, int32_t first_px,
                       const SmallSpans& spans)
      : lanes(set_up.maps, i,
              {hn::Sub(spans.left_px, hn::Set(D32(), first_px)), hn::Iota(D32(), 0)}) {
    hn::Store(spans.left_px, D32(), left_px);
    hn::Store(hn::Sub(spans.right_px, spans.left_px), D32(), count_px);
  }
};

// One of those that were set up.
template <class Kind>
struct SmallPolygon {
  const SmallSetUp<Kind>& set_up;
  size_t i;
  const SmallRows<Kind>& rows;
  int32_t first_px, first_row, end_row;

  // Calls draw(k, count_px, to) for each row, the k-th.
  template <class Pixel, class Draw>
  HWY_INLINE void for_each_row(const selvage_image& target, const Draw& draw) const {
    char* const pixels = static_cast<char*>(target.pixels);
    // Modulo 2^64: a pitch below the last row there may be no address.
    const auto pitch = static_cast<size_t>(target.pitch);
    size_t row = static_cast<size_t>(first_row) * pitch;
    for (int32_t k = 0; k < end_row - first_row; ++k) {
      auto* const to = reinterpret_cast<Pixel*>(pixels + static_cast<ptrdiff_t>(row));
      draw(k, rows.count_px[k], to + rows.left_px[k]);
      row += pitch;
    }
  }
};

// Returns whether there is a near-tie among the pixels, of which all are drawn.
template <class Pixel, class Kind, class Source>
[[nodiscard]] HWY_INLINE bool draw_by_lanes(const SmallPolygon<Kind>& polygon, const Source& source,
                                            const selvage_image& target) {
  const LowFineLanes low(polygon.set_up.maps.lack_fx24(polygon.i));
  const typename Kind::Rows::Walk walk(polygon.set_up.maps, polygon.i);
  V32 changed = hn::Zero(D32());
  polygon.template for_each_row<Pixel>(
      target, [&](int32_t k, int32_t count_px, Pixel* to) HWY_ATTR {
        changed = source.draw(low, walk.along(polygon.rows.lanes, k), count_px, changed, to);
      });
  return changes_texels<kWindowFraction>(changed);
}

template <class Pixel, class Kind, class Source>
HWY_NOINLINE void draw_exactly(const SmallPolygon<Kind>& polygon, const Source& source,
                               const Surface& surface) {
  const D32 d;
  const auto exact = polygon.set_up.exact(polygon.i, surface.texture);
  polygon.template for_each_row<Pixel>(
      surface.target, [&](int32_t k, int32_t count_px, Pixel* to) HWY_ATTR {
        if (count_px == 0) return;
        const int32_t right_px = polygon.rows.left_px[k] - polygon.first_px;
        const PixelSteps steps{hn::Iota(d, right_px), hn::Set(d, k)};
        source.draw(exact.at(steps, count_px), count_px, to);
      });
}

// Texels from a window, or each by itself, by lanes that are counted from its first one.
template <class Pixel, int kShape>
class SmallSource {
 public:
  HWY_INLINE SmallSource(const selvage_texture& texture, int32_t s, int32_t t)
      : window_(texture, {{s, s}, {t, t}, kSmallShapes[size_t{kShape}].vectors}) {}

  // As draw_some() does.
  [[nodiscard]] HWY_INLINE V32 draw(const LowFineLanes& low, const LaneVectors& lanes,
                                    int32_t count_px, V32 changed, Pixel* to) const {
    return draw_some(window_, low, lanes, count_px, changed, to);
  }
  // The first pixels of a vector, by lanes of 16.16 that lack nothing.
  HWY_INLINE void draw(const LaneVectors& lanes, int32_t count_px, Pixel* to) const {
    store_first(window_.template texels<kTexelFraction>(lanes), count_px, to);
  }

 private:
  Window<Pixel, Addressed<InsideVector>, kSmallShapes[size_t{kShape}].column_bits,
         kSmallShapes[size_t{kShape}].vectors>
      window_;
};
template <class Pixel>
class SmallSource<Pixel, kSmallShapeCount> {
 public:
  HWY_INLINE SmallSource(const selvage_texture& texture, int32_t s, int32_t t)
      : first_(static_cast<const Pixel*>(texture.texels) + t * pitch_texel_of(texture) + s),
        pitch_texel_(static_cast<int32_t>(pitch_texel_of(texture))) {}

  [[nodiscard]] HWY_INLINE V32 draw(const LowFineLanes& low, const LaneVectors& lanes,
                                    int32_t count_px, V32 changed, Pixel* to) const {
    const D32 d;
    fetch<LowFineLanes::kFraction>(lanes, count_px, to);
    const auto is_pixel = hn::Gt(hn::Set(d, count_px), hn::Iota(d, 0));
    return hn::IfThenElse(is_pixel, hn::Or(changed, low.changes(lanes)), changed);
  }
  HWY_INLINE void draw(const LaneVectors& lanes, int32_t count_px, Pixel* to) const {
    fetch<kTexelFraction>(lanes, count_px, to);
  }

 private:
  // Of the first texel's row or column, lanes of 8.24 may be less than 0 by what they lack.
  template <int kFraction>
  HWY_INLINE void fetch(const LaneVectors& lanes, int32_t count_px, Pixel* to) const {
    const D32 d;
    const V32 s = hn::Max(hn::ShiftRight<kFraction>(lanes.u), hn::Zero(d)),
              t = hn::Max(hn::ShiftRight<kFraction>(lanes.v), hn::Zero(d));
    fetch_first<Pixel>(first_, hn::Add(hn::Mul(t, hn::Set(d, pitch_texel_)), s), count_px,
                       reinterpret_cast<char*>(to));
  }

  const Pixel* first_;
  int32_t pitch_texel_;
};

template <class Pixel, int kShape, class Kind>
HWY_INLINE void draw_small_polygon(const SmallPolygon<Kind>& polygon, const Surface& surface) {
  const SmallSource<Pixel, kShape> source(surface.texture, polygon.set_up.s_texel[polygon.i],
                                          polygon.set_up.t_texel[polygon.i]);
  const bool has_lanes = polygon.set_up.maps.has_lanes(polygon.i);
  if (HWY_LIKELY(has_lanes && !draw_by_lanes<Pixel>(polygon, source, surface.target))) return;
  draw_exactly<Pixel>(polygon, source, surface);
}

// By its shape, one of kShape or above.
template <class Pixel, class Kind, int kShape = 0>
HWY_INLINE void draw_by_shape(const SmallPolygon<Kind>& polygon, const Surface& surface) {
  if constexpr (kShape < kSmallShapeCount) {
    if (polygon.set_up.shape[polygon.i] != kShape) {
      return draw_by_shape<Pixel, Kind, kShape + 1>(polygon, surface);
    }
  }
  draw_small_polygon<Pixel, kShape>(polygon, surface);
}

// Of those that were set up, the one with an index.
template <class Pixel, class Kind>
HWY_INLINE void draw_small_set(const SmallPolygons& polygons, const SmallSetUp<Kind>& set_up,
                               size_t first, size_t end, const Surface& surface) {
  for (size_t index = first; index < end; ++index) {
    const size_t i = index - first;
    const int32_t first_px = polygons.left_px()[index];
    const SmallRows<Kind> rows(set_up, i, first_px, polygons.right_px()[index]);
    draw_by_shape<Pixel>(SmallPolygon<Kind>{set_up, i, rows, first_px, polygons.first_row()[index],
                                            polygons.end_row()[index]},
                         surface);
  }
}

#endif

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
