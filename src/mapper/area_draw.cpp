#include "mapper/area_draw.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "mapper/channels.h"
#include "mapper/filter_blend.h"
#include "mapper/filter_box.h"
#include "mapper/filter_point.h"
#include "mapper/footprint.h"
#include "mapper/lanes.h"
#include "mapper/plane.h"
#include "mapper/span.h"
#include "mapper/span_walk.h"

namespace selvage::mapper {
namespace {

// So many pixels go through the stages at a time: their points stay in the nearest cache.
inline constexpr int32_t kPiece_px = 256;

// One row of a polygon and what is drawn on it.
struct Row {
  const Surface& surface;
  Span span;
  SpanMap map;
  Footprint footprint;
  std::optional<BoxSides> same_sides;  // where all pixels of the polygon have these
};

void mean_boxes(const Row& row, int32_t first_px, std::span<const FilterPoint> points,
                char* pixels) {
  constexpr BoxSides kLeast{kLeastSide_fx8, kLeastSide_fx8};
  for (size_t i = 0; i < points.size(); ++i, pixels += kPixelBytes) {
    const BoxSides sides =
        row.same_sides ? *row.same_sides : row.footprint.at(first_px + static_cast<int32_t>(i));
    if (sides == kLeast) {
      blend_bilinear(points.subspan(i, 1), row.surface.texture, row.surface.address, pixels);
    } else {
      store_pixel(pixels, box_mean(row.surface.texture, row.surface.address,
                                   Box::around(points[i], sides)));
    }
  }
}

template <class Lanes>
void draw_row(const Row& row, const Lanes& lanes) {
  std::array<FilterPoint, kPiece_px> points;
  char* const pixels =
      static_cast<char*>(row.surface.target.pixels) + row.span.row * row.surface.target.pitch;
  for (int32_t from_px = row.span.left_px; from_px < row.span.right_px; from_px += kPiece_px) {
    const int32_t count = std::min(kPiece_px, row.span.right_px - from_px);
    for (int32_t i = 0; i < count; ++i) {
      points[static_cast<size_t>(i)] =
          filter_point(ExactMap(row.map), row.span, lanes, from_px + i);
    }
    mean_boxes(row, from_px, std::span(points).first(static_cast<size_t>(count)),
               pixels + ptrdiff_t{from_px} * kPixelBytes);
  }
}

}  // namespace

void draw_area(const Surface& surface, const selvage_rect& visible, const Polygon& polygon) {
  const std::optional<Plane> plane = Plane::of(polygon, visible);
  std::optional<BoxSides> plane_sides;
  SpanWalk walk(polygon, visible);
  while (walk.next()) {
    const Span& span = walk.span();
    const Edge &left = walk.left(), &right = walk.right();
    const Footprint footprint(left.at(span.row), left.change(), right.at(span.row), right.change());
    if (plane && !plane_sides) plane_sides = footprint.at(span.left_px);
    const Row row{surface, span, walk.map(), footprint, plane_sides};
    if (polygon.affine) {
      draw_row(row, plane ? plane->lanes() : AffineLanes(row.map, span).field(span));
    } else {
      draw_row(row, ProjectiveLanes(row.map, span));
    }
  }
}

}  // namespace selvage::mapper
