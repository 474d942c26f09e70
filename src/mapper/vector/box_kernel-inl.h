// The area filter by vectors: points and sides of kLanes pixels at a time, then their means.
// Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_BOX_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BOX_KERNEL_INL_H
#undef SELVAGE_VECTOR_BOX_KERNEL_INL_H
#else
#define SELVAGE_VECTOR_BOX_KERNEL_INL_H
#endif

#include <array>
#include <type_traits>

#include "mapper/box_row.h"
#include "mapper/plane_footprint.h"
#include "mapper/vector/blend_points-inl.h"
#include "mapper/vector/box_sums-inl.h"
#include "mapper/vector/entries-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

static_assert(kBoxPieceSpare_px >= kLanes - 1);

// ---- Points and sides ---------------------------------------------------------------------------

template <class Steps>
HWY_INLINE void find_points(const Steps& steps, const Span& piece, RowOfTies* ties,
                            BoxRow* HWY_RESTRICT boxes) {
  const D32 d;
  typename Steps::Points points(steps, piece.left_px, piece.row, ties);
  for (int32_t i = 0;;) {
    const PointVectors at = points.points();
    hn::StoreU(at.u_fx8, d, boxes->u_fx8.data() + i);
    hn::StoreU(at.v_fx8, d, boxes->v_fx8.data() + i);
    i += kLanes;
    if (i >= piece.width_px()) break;
    points.advance();
  }
}

// One side of kDoubles boxes: ceils of its bounds.
struct SideVectors {
  hn::Vec<DHalf> least_fx8, most_fx8;
};

[[nodiscard]] HWY_INLINE hn::Vec<DHalf> ceil_sides(VD side_fx8) {
  const DD d;
  const VD inside = hn::Min(hn::Max(side_fx8, hn::Set(d, double{kLeastSide_fx8})),
                            hn::Set(d, double{kMostSide_fx8}));
  return hn::DemoteTo(DHalf(), hn::Ceil(inside));
}

[[nodiscard]] HWY_INLINE SideVectors sides_of(const FootprintLine& line, VD offset_px, VD weight) {
  const DD d;
  const VD down = hn::MulAdd(offset_px, hn::Set(d, line.down_step), hn::Set(d, line.down_start));
  const VD changes = hn::Add(hn::Abs(down), hn::Set(d, line.across));
  const VD slack = hn::Set(d, line.slack);
  return {ceil_sides(hn::Mul(hn::Mul(hn::Sub(changes, slack), weight), weight)),
          ceil_sides(hn::Mul(hn::Mul(hn::Add(changes, slack), weight), weight))};
}

// Of the boxes of a vector, where bounds differ. Rare, and kept out of the loop.
using SideLanes = std::array<int32_t, kDoubles>;
HWY_NOINLINE void decide_sides(const PlaneFootprint& footprint, const Span& piece, int32_t from,
                               const SideLanes& least_u, const SideLanes& least_v, BoxRow* boxes) {
  const int32_t end = HWY_MIN(from + kDoubles, piece.width_px());
  for (int32_t i = from; i < end; ++i) {
    const auto at = static_cast<size_t>(i), lane = static_cast<size_t>(i - from);
    const BoxSides least{least_u[lane], least_v[lane]};
    const BoxSides most{boxes->width_fx8[at], boxes->height_fx8[at]};
    if (least == most) continue;
    boxes->set_sides(i, footprint.exact(piece.left_px + i, piece.row, least, most));
  }
}

HWY_INLINE void find_sides(const PlaneFootprint& footprint, const FootprintRow& row,
                           const Span& piece, BoxRow* HWY_RESTRICT boxes) {
  const DD d;
  const DHalf d32;
  for (int32_t i = 0; i < piece.width_px(); i += kDoubles) {
    const VD at = hn::Iota(d, static_cast<double>(i));
    const VD denominator =
        hn::MulAdd(at, hn::Set(d, row.denominator.step), hn::Set(d, row.denominator.start));
    const VD weight = hn::Div(hn::Set(d, 1.0), denominator);
    const SideVectors u = sides_of(row.u, at, weight), v = sides_of(row.v, at, weight);
    hn::StoreU(u.most_fx8, d32, boxes->width_fx8.data() + i);
    hn::StoreU(v.most_fx8, d32, boxes->height_fx8.data() + i);
    if (HWY_LIKELY(hn::AllTrue(d32, hn::Eq(u.least_fx8, u.most_fx8)) &&
                   hn::AllTrue(d32, hn::Eq(v.least_fx8, v.most_fx8)))) {
      continue;
    }
    SideLanes least_u, least_v;
    hn::StoreU(u.least_fx8, d32, least_u.data());
    hn::StoreU(v.least_fx8, d32, least_v.data());
    decide_sides(footprint, piece, i, least_u, least_v, boxes);
  }
}

// ---- Spans --------------------------------------------------------------------------------------

// So far ahead texels are asked for, of textures that no near cache holds.
inline constexpr int32_t kAhead_px = 12;

template <class Means>
HWY_INLINE void draw_means(const BoxRow& boxes, const Span& piece, const Surface& surface,
                           const Means& mean) {
  char* const pixels = first_pixel(surface, piece);
  const int32_t width_px = piece.width_px();
  for (int32_t i = 0; i < width_px; ++i) {
    if (mean.is_large() && i + kAhead_px < width_px) mean.prefetch(boxes.box(i + kAhead_px));
    store_pixel(pixels + i * ptrdiff_t{kPixelBytes}, mean(boxes.box(i)));
  }
}

template <class Means>
HWY_NOINLINE void draw_affine_means(const AffineSpans& spans, BoxSides sides,
                                    const Surface& surface) {
  BoxRow boxes;
  boxes.width_fx8.fill(sides.u_fx8);
  boxes.height_fx8.fill(sides.v_fx8);
  const Means means(surface);
  const AffineSteps steps(spans);
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    RowOfTies ties(spans.exact, span, kGridBits, 0);
    for_each_box_piece(span, [&](const Span& piece) {
      find_points(steps, piece, &ties, &boxes);
      draw_means(boxes, piece, surface, means);
    });
  }
}

template <class Means>
HWY_NOINLINE void draw_projective_means(const ProjectiveSpans& spans,
                                        const PlaneFootprint& footprint, const Surface& surface) {
  BoxRow boxes;
  const Means means(surface);
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    RowOfTies ties(spans.exact, span, kGridBits, 0);
    const ProjectiveSteps steps(spans, span);
    for_each_box_piece(span, [&](const Span& piece) {
      const FootprintRow row = footprint.row(piece);
      if (row.is_least(piece.width_px())) {
        return draw_bilinear_projective({one_span(piece), spans.field, spans.texels, spans.exact},
                                        surface);
      }
      find_points(steps, piece, &ties, &boxes);
      find_sides(footprint, row, piece, &boxes);
      draw_means(boxes, piece, surface, means);
    });
  }
}

template <class Means>
HWY_NOINLINE void draw_given_means(const BoxRow& boxes, const Span& piece, const Surface& surface) {
  draw_means(boxes, piece, surface, Means(surface));
}

// Calls draw with the type of the means of such a surface.
template <class Edge, class Layout, class Draw>
HWY_INLINE void with_means_of(const Surface& surface, const Draw& draw) {
  if (surface.texture.prepared == nullptr) {
    return draw(std::type_identity<BoxMeans<Edge, Layout>>());
  }
  draw(std::type_identity<SummedMeans<Edge, Layout>>());
}
template <class Draw>
HWY_INLINE void with_means(const Surface& surface, const Draw& draw) {
  if (HWY_UNLIKELY(PlainMeans::is_for(surface.texture))) {
    return draw(std::type_identity<PlainMeans>());
  }
  with_layout(surface.texture.layout, [&](auto layout) {
    using Layout = decltype(layout);
    if (surface.address == SELVAGE_ADDRESS_CLAMP) {
      return with_means_of<ClampEdge, Layout>(surface, draw);
    }
    with_means_of<WrapEdge, Layout>(surface, draw);
  });
}

}  // namespace

void draw_boxes_affine(const AffineSpans& spans, BoxSides sides, const Surface& surface) {
  with_means(surface, [&](auto means) {
    draw_affine_means<typename decltype(means)::type>(spans, sides, surface);
  });
}

void draw_boxes_projective(const ProjectiveSpans& spans, const PlaneFootprint& footprint,
                           const Surface& surface) {
  with_means(surface, [&](auto means) {
    draw_projective_means<typename decltype(means)::type>(spans, footprint, surface);
  });
}

void draw_boxes(const BoxRow& boxes, const Span& piece, const Surface& surface) {
  with_means(surface, [&](auto means) {
    draw_given_means<typename decltype(means)::type>(boxes, piece, surface);
  });
}

}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
