#include "mapper/filter_draw.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "mapper/channels.h"
#include "mapper/edge.h"
#include "mapper/filter_blend.h"
#include "mapper/filter_box.h"
#include "mapper/filter_point.h"
#include "mapper/footprint.h"
#include "mapper/lanes.h"
#include "mapper/plane.h"
#include "mapper/span.h"

namespace selvage::mapper {
namespace {

// So many pixels go through the stages at a time: their points stay in the nearest cache.
inline constexpr int32_t kPiece_px = 256;

// One row of a polygon and what is drawn on it.
struct Row {
  const selvage_texture& texture;
  selvage_address address;
  selvage_filter filter;
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
      blend_bilinear(points.subspan(i, 1), row.texture, row.address, pixels);
    } else {
      store_pixel(pixels, box_mean(row.texture, row.address, Box::around(points[i], sides)));
    }
  }
}

void mix_texels(const Row& row, int32_t first_px, std::span<const FilterPoint> points,
                char* pixels) {
  switch (row.filter) {
    case SELVAGE_FILTER_FOUR:
      return blend_four(points, row.texture, row.address, pixels);
    case SELVAGE_FILTER_BILINEAR:
      return blend_bilinear(points, row.texture, row.address, pixels);
    default:
      return mean_boxes(row, first_px, points, pixels);
  }
}

template <class Lanes>
void draw_row(const Row& row, const Lanes& lanes, char* pixels) {
  std::array<FilterPoint, kPiece_px> points;
  const Span& span = row.span;
  for (int32_t done_px = 0; done_px < span.width_px(); done_px += kPiece_px) {
    const int32_t count = std::min(kPiece_px, span.width_px() - done_px);
    for (int32_t i = 0; i < count; ++i) {
      points[static_cast<size_t>(i)] = filter_point(row.map, span, lanes, done_px + i);
    }
    const int32_t first_px = span.left_px + done_px;
    mix_texels(row, first_px, std::span(points).first(static_cast<size_t>(count)),
               pixels + ptrdiff_t{first_px} * kPixelBytes);
  }
}

}  // namespace

void draw_filtered(const selvage_image& target, const selvage_rect& visible, const Polygon& polygon,
                   const selvage_texture& texture, selvage_address address, selvage_filter filter) {
  const int32_t first_row = std::max(polygon.top_row, visible.top);
  const int32_t end_row = std::min(polygon.bottom_row, visible.bottom);
  if (first_row >= end_row || visible.left >= visible.right) return;
  Chain forward(polygon, Chain::Direction::kForward);
  Chain backward(polygon, Chain::Direction::kBackward);
  const std::optional<Plane> plane = Plane::of(polygon, visible);
  std::optional<BoxSides> plane_sides;

  for (int32_t y_px = first_row; y_px < end_row; ++y_px) {
    const Edge& a = forward.at_row(y_px);
    const Edge& b = backward.at_row(y_px);
    const bool a_is_left = a.first_px() <= b.first_px();
    const Edge& left = a_is_left ? a : b;
    const Edge& right = a_is_left ? b : a;
    const Span span{.row = y_px,
                    .left_px = std::max(left.first_px(), visible.left),
                    .right_px = std::min(right.first_px(), visible.right)};
    if (span.empty()) continue;
    const EdgePoint from = left.at(y_px), to = right.at(y_px);
    const Footprint footprint(from, left.change(), to, right.change());
    if (plane && filter == SELVAGE_FILTER_AREA && !plane_sides) {
      plane_sides = footprint.at(span.left_px);
    }
    const Row row{texture, address, filter, span, SpanMap(from, to), footprint, plane_sides};
    char* const pixels = static_cast<char*>(target.pixels) + y_px * target.pitch;
    if (!polygon.affine) {
      draw_row(row, ProjectiveLanes(row.map, span), pixels);
    } else {
      draw_row(row, plane ? plane->lanes(span) : AffineLanes(row.map, span), pixels);
    }
  }
}

}  // namespace selvage::mapper
