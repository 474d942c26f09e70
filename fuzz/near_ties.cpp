#include "fuzz/near_ties.h"

#include <algorithm>
#include <optional>

#include "mapper/affine_slab.h"
#include "mapper/filter_point.h"
#include "mapper/gentle_pieces.h"
#include "mapper/plane.h"
#include "mapper/polygon.h"
#include "mapper/projective_plane.h"
#include "mapper/projective_slab.h"
#include "mapper/slab.h"
#include "mapper/span_batch.h"
#include "mapper/span_walk.h"
#include "mapper/texel_index.h"
#include "mapper/vector/kernel.h"
#include "spec/exact.h"

namespace selvage::fuzz {
namespace {

using mapper::Lane;
using mapper::Span;

[[nodiscard]] selvage_rect visible_rect(const spec::Case& c) {
  selvage_rect rect{0, 0, c.target_width_px, c.target_height_px};
  if (!c.has_clip) return rect;
  return {std::max(rect.left, c.clip.left), std::max(rect.top, c.clip.top),
          std::min(rect.right, c.clip.right), std::min(rect.bottom, c.clip.bottom)};
}

class Counter {
 public:
  explicit Counter(const spec::Case& c)
      : case_(c),
        on_grid_(c.filter != SELVAGE_FILTER_NEAREST),
        shift_(on_grid_ ? mapper::kGridFraction : mapper::kLaneFraction),
        extra_fx32_(on_grid_ ? 0 : kVectorsLack_fx32) {}

  // The pixels of a row, and of its lanes.
  template <class LaneAt>
  void count(const Span& span, uint32_t margin_fx32, const LaneAt& lane_at) {
    const auto line = spec::scan_line(case_.vertices, span.row);
    for (int32_t first_px = span.left_px; first_px < span.right_px; first_px += kRun_px) {
      const int64_t near_before = found.near;
      for (int32_t px = first_px; px < std::min(first_px + kRun_px, span.right_px); ++px) {
        const Lane lane = lane_at(px);
        const auto exact = spec::sample(*line, px);
        count(lane.u_fx32, margin_fx32, exact->u);
        count(lane.v_fx32, margin_fx32, exact->v);
      }
      ++found.runs;
      found.near_runs += found.near > near_before ? 1 : 0;
    }
  }
  void fail(const char* what) { found.fault = what; }

  NearTies found;

 private:
  // The nearest lanes of the vector kernels have 16 bits less.
  static constexpr int64_t kVectorsLack_fx32 =
      int64_t{std::max(mapper::kVectorTruncations_fx16, mapper::kDividedTruncations_fx16) + 1}
      << mapper::kTexelFraction;

  void count(int64_t lane_fx32, uint32_t margin_fx32, const spec::Rational& texel) {
    const int64_t unit = int64_t{1} << shift_, most_lack = margin_fx32 + extra_fx32_;
    ++found.coordinates;
    const bool is_near = (lane_fx32 & (unit - 1)) + most_lack >= unit;
    const spec::Rational exact =
        texel * static_cast<double>(int64_t{1} << (mapper::kLaneFraction - shift_));
    const int32_t whole = spec::floor(exact), low = static_cast<int32_t>(lane_fx32 >> shift_);
    if (whole != low && !(is_near && whole == low + 1)) fail("one decision is not enough");
    if (!is_near) return;
    ++found.near;
    const spec::Rational above = exact - whole, below = 1 - above;
    const double most_doubt = on_grid_ ? kMostDoubt_grid : kMostDoubt_texel;
    if (above > most_doubt && below > most_doubt) fail("a decision in vain");
  }

  const spec::Case& case_;
  bool on_grid_;
  int shift_;
  int64_t extra_fx32_;
};

void count_affine_field(const mapper::AffineField& field, mapper::SpanWalk walk, Counter* counter) {
  while (walk.next()) {
    const Span& span = walk.span();
    counter->count(span, field.margin_fx32, [&](int32_t px) { return field.at(px, span.row); });
  }
}

void count_field(const mapper::ProjectiveField& field, mapper::SpanWalk walk, Counter* counter) {
  while (walk.next()) {
    const Span& span = walk.span();
    const mapper::DividedLanes lanes = field.of(span);
    counter->count(span, lanes.margin_fx32(),
                   [&](int32_t px) { return lanes.at(px - span.left_px); });
  }
}

void count_ruled_affine(const mapper::Slab& slab, const mapper::Polygon& polygon,
                        const selvage_rect& rows, Counter* counter) {
  mapper::BatchWalk walk(polygon, rows, mapper::find_spans_scalar);
  mapper::SpanBatch batch;
  mapper::RuledRows lanes;
  while (walk.next(&batch)) {
    mapper::find_lanes(std::span(&slab, 1), batch, mapper::find_ruled_lanes_scalar, &lanes);
    for (int32_t i = 0; i < batch.rows; ++i) {
      const Span span = batch.span(i);
      const mapper::AffineLanes row = lanes.lanes(i);
      counter->count(span, lanes.margin_fx32,
                     [&](int32_t px) { return row.at(px - span.left_px); });
    }
  }
}

void count_affine_row(const mapper::SpanWalk& walk, Counter* counter) {
  const Span& span = walk.span();
  const mapper::AffineLanes lanes(walk.map(), span);
  counter->count(span, lanes.margin_fx32(),
                 [&](int32_t px) { return lanes.at(px - span.left_px); });
}

// A row by its own lanes, whole or in gentle pieces.
void count_row(const mapper::SpanWalk& walk, Counter* counter) {
  const mapper::SpanMap map = walk.map();
  int32_t pieces = 0;
  const auto count = [&](const Span& piece) {
    const mapper::ProjectiveLanes lanes(map, piece);
    ++pieces;
    counter->count(piece, lanes.margin_fx32(),
                   [&](int32_t px) { return lanes.at(px - piece.left_px); });
  };
  const mapper::ProjectiveLanes whole(map, walk.span());
  const double growth = whole.denominator().step;
  if (growth != 0) counter->found.kind = MapKind::kInDepth;
  if (whole.ratio() <= mapper::kGentleRatio) {
    count(walk.span());
  } else {
    mapper::for_each_gentle_piece(walk.span(), growth > 0, count);
  }
  if (pieces > mapper::kMostPieces) counter->fail("too many pieces");
}

// A polygon by one map of all its rows, if it has one.
[[nodiscard]] bool count_plane(const mapper::Polygon& polygon, const selvage_rect& part,
                               Counter* counter) {
  if (const auto plane = mapper::Plane::of(polygon, part)) {
    count_affine_field(plane->lanes(), mapper::SpanWalk(polygon, part), counter);
    return true;
  }
  const auto plane = mapper::ProjectivePlane::of(polygon, part);
  if (polygon.affine || !plane) return false;
  counter->found.kind = MapKind::kInDepth;
  count_field(plane->lanes(), mapper::SpanWalk(polygon, part), counter);
  return true;
}

// As draw() takes a slab: by its plane, or by the formula of its rows.
[[nodiscard]] bool count_slab(const mapper::Slab& slab, const selvage_rect& part,
                              Counter* counter) {
  if (slab.rows() < mapper::kLeastSlabRows) return false;
  const mapper::SlabOutline outline(slab);
  const mapper::Polygon polygon = outline.polygon();
  const selvage_rect rows =
      mapper::part_of(polygon, {part.left, slab.first_row, part.right, slab.end_row});
  if (mapper::is_empty(rows) || count_plane(polygon, rows, counter)) return true;
  if (polygon.affine) {
    count_ruled_affine(slab, polygon, rows, counter);
    return true;
  }
  const auto field = mapper::ruled_field(slab, polygon, rows);
  if (!field) return false;
  counter->found.kind = MapKind::kRuledInDepth;
  count_field(*field, mapper::SpanWalk(polygon, rows), counter);
  return true;
}

void count_slabs(const mapper::Polygon& polygon, const selvage_rect& part, Counter* counter) {
  mapper::SlabWalk slabs(polygon, part);
  mapper::SpanWalk spans(polygon, part);
  while (const auto slab = slabs.next()) {
    if (count_slab(*slab, part, counter)) {
      spans.skip_to(slab->end_row);
    } else {
      const auto count = polygon.affine ? count_affine_row : count_row;
      while (spans.next_above(slab->end_row)) count(spans, counter);
    }
  }
}

}  // namespace

NearTies count_near_ties(const spec::Case& c) {
  mapper::Polygon polygon;
  const selvage_rect visible = visible_rect(c);
  if (mapper::examine(c.vertices, &polygon) != SELVAGE_OK || polygon.untransformed ||
      visible.left >= visible.right || visible.top >= visible.bottom) {
    return {};
  }
  const selvage_rect part = mapper::part_of(polygon, visible);
  if (mapper::is_empty(part)) return {};
  Counter counter(c);
  if (count_plane(polygon, part, &counter)) return counter.found;
  counter.found.kind = polygon.affine ? MapKind::kRuledAffine : MapKind::kSameDepthAlongRows;
  count_slabs(polygon, part, &counter);
  return counter.found;
}

}  // namespace selvage::fuzz
