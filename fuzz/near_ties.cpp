#include "fuzz/near_ties.h"

#include <algorithm>
#include <optional>

#include "mapper/filter_point.h"
#include "mapper/gentle_pieces.h"
#include "mapper/plane.h"
#include "mapper/polygon.h"
#include "mapper/projective_plane.h"
#include "mapper/span_walk.h"
#include "mapper/texel_index.h"
#include "mapper/vector_kernel.h"
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

void count_plane(const mapper::Plane& plane, mapper::SpanWalk& walk, Counter* counter) {
  const mapper::AffineField& field = plane.lanes();
  while (walk.next()) {
    const Span& span = walk.span();
    counter->count(span, field.margin_fx32, [&](int32_t px) { return field.at(px, span.row); });
  }
}

void count_projective_plane(const mapper::ProjectivePlane& plane, mapper::SpanWalk& walk,
                            Counter* counter) {
  while (walk.next()) {
    const Span& span = walk.span();
    const mapper::DividedLanes lanes = plane.lanes().of(span);
    counter->count(span, lanes.margin_fx32(),
                   [&](int32_t px) { return lanes.at(px - span.left_px); });
  }
}

void count_ruled_affine(mapper::SpanWalk& walk, Counter* counter) {
  while (walk.next()) {
    const Span& span = walk.span();
    const mapper::AffineField field = mapper::AffineLanes(walk.map(), span).field(span);
    counter->count(span, field.margin_fx32, [&](int32_t px) { return field.at(px, span.row); });
  }
}

void count_in_depth(mapper::SpanWalk& walk, Counter* counter) {
  while (walk.next()) {
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
}

}  // namespace

NearTies count_near_ties(const spec::Case& c) {
  mapper::Polygon polygon;
  const selvage_rect visible = visible_rect(c);
  if (mapper::examine(c.vertices, &polygon) != SELVAGE_OK || polygon.untransformed ||
      visible.left >= visible.right || visible.top >= visible.bottom) {
    return {};
  }
  Counter counter(c);
  mapper::SpanWalk walk(polygon, visible);
  if (const std::optional<mapper::Plane> plane = mapper::Plane::of(polygon, visible)) {
    count_plane(*plane, walk, &counter);
  } else if (polygon.affine) {
    counter.found.kind = MapKind::kRuledAffine;
    count_ruled_affine(walk, &counter);
  } else if (const auto in_depth = mapper::ProjectivePlane::of(polygon, visible)) {
    counter.found.kind = MapKind::kInDepth;
    count_projective_plane(*in_depth, walk, &counter);
  } else {
    counter.found.kind = MapKind::kSameDepthAlongRows;
    count_in_depth(walk, &counter);
  }
  return counter.found;
}

}  // namespace selvage::fuzz
