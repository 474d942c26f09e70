// The anchors and windows of pairs of rows in perspective. Included once for each SIMD target.
//
// Anchors are further apart than those of pieces: where windows hold two rows, texels are wide, and
// walks from anchors short.
#if defined(SELVAGE_VECTOR_PROJECTIVE_PAIR_WINDOWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PROJECTIVE_PAIR_WINDOWS_INL_H
#undef SELVAGE_VECTOR_PROJECTIVE_PAIR_WINDOWS_INL_H
#else
#define SELVAGE_VECTOR_PROJECTIVE_PAIR_WINDOWS_INL_H
#endif

#include <bit>

#include "mapper/vector/piece_windows-inl.h"
#include "mapper/vector/row_pairs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

inline constexpr int32_t kVectorsPerAnchor = kPairAnchor_px / kLanes;

// Vectors side by side of two rows: their anchors, one of the upper row, then one of the lower;
// what walks from there are added to, so that lanes are counted from the window, raised by all that
// they lack, and by kWholeNumbers, as bits; the windows' places; and their rows, as of
// PieceWindows, or 0 where there is none.
struct PairWindows {
  static constexpr int32_t kMost = 64;
  static constexpr int32_t kAnchors = 2 * kMost / kVectorsPerAnchor;
  static_assert(kMost % kLanes == 0 && kAnchors % kDoubles == 0);

  HWY_ALIGN float turn[kAnchors], u_rise[kAnchors], v_rise[kAnchors];
  HWY_ALIGN float upper_u[kMost], upper_v[kMost], lower_u[kMost], lower_v[kMost];
  HWY_ALIGN int32_t place[kMost], rows[kMost];
};

class PairFinder {
 public:
  HWY_INLINE PairFinder(const AnchoredVectors& vectors, const Extent& extent)
      : vectors_(vectors), extent_(extent) {
    static_assert(!kHasPairs || 2 * kLanes == kDoubles * kVectorsPerAnchor);
  }

  // Of all vectors of a run.
  HWY_NOINLINE void find(const PairRun& run, PairWindows* found) const {
    const DHalf half;
    const DHalfFloat floats;
    const VHalf at = hn::Iota(half, 0);
    const auto is_upper = hn::Eq(hn::And(at, hn::Set(half, 1)), hn::Zero(half));
    const VHalf row =
        hn::IfThenElse(is_upper, hn::Set(half, run.upper.row), hn::Set(half, run.lower.row));
    const VHalf right_by_px = hn::Mul(hn::ShiftRight<1>(at), hn::Set(half, kPairAnchor_px));
    for (int32_t k = 0, to = 0; k < run.vectors; k += kLanes, to += kDoubles) {
      const VHalf px = hn::Add(right_by_px, hn::Set(half, run.px + k * kLanes));
      const HalfAnchors anchors = vectors_.at(px, row);
      hn::StoreU(anchors.turn, floats, found->turn + to);
      hn::StoreU(anchors.u_rise, floats, found->u_rise + to);
      hn::StoreU(anchors.v_rise, floats, found->v_rise + to);
      find_windows(anchors, k, found);
    }
  }

 private:
  using HalfAnchors = AnchoredVectors::HalfAnchors;

  // The anchors of kLanes vectors of a row, and, in 16.16, where in them u and v are least and
  // most.
  struct RowEnds {
    V32 u_anchor, v_anchor;
    V32 least_u, most_u, least_v, most_v;
  };

  // By every other anchor from the first one on.
  static HWY_INLINE RowEnds row_ends(const HalfAnchors& anchors, int32_t first) {
    const D32 d;
    const DFloat df;
    const V32 vector = hn::Iota(d, 0);
    constexpr int kBits = std::countr_zero(static_cast<uint32_t>(kVectorsPerAnchor));
    const V32 anchor = hn::Add(hn::ShiftLeft<1>(hn::ShiftRight<kBits>(vector)), hn::Set(d, first));
    const auto index = hn::IndicesFromVec(d, anchor);
    const auto of = [&](VHalf half) HWY_ATTR {
      return hn::TableLookupLanes(hn::ZeroExtendVector(d, half), index);
    };
    const auto floats_of = [&](VHalfFloat half)
                               HWY_ATTR { return hn::BitCast(df, of(hn::BitCast(DHalf(), half))); };
    const V32 first_px =
        hn::Mul(hn::And(vector, hn::Set(d, kVectorsPerAnchor - 1)), hn::Set(d, kLanes));
    const VFloat turn = floats_of(anchors.turn);
    const auto share = [&](V32 px) HWY_ATTR { return share_of(df, hn::ConvertTo(df, px), turn); };
    const VFloat left = share(first_px), right = share(hn::Add(first_px, hn::Set(d, kLanes - 1)));
    const auto ends = [&](V32 from, VFloat rise, V32* least, V32* most) HWY_ATTR {
      const V32 at_left = hn::Add(from, walk_of(df, left, rise));
      const V32 at_right = hn::Add(from, walk_of(df, right, rise));
      *least = hn::Min(at_left, at_right);
      *most = hn::Max(at_left, at_right);
    };
    RowEnds row;
    row.u_anchor = of(anchors.u_fx16);
    row.v_anchor = of(anchors.v_fx16);
    ends(row.u_anchor, floats_of(anchors.u_rise), &row.least_u, &row.most_u);
    ends(row.v_anchor, floats_of(anchors.v_rise), &row.least_v, &row.most_v);
    return row;
  }

  // The texels of lanes between these, whatever they lack. Where a row has no pixels, its lanes may
  // be anything, the greatest number, too: no sum of it may count few texels.
  HWY_INLINE TexelRun texels_between(V32 least, V32 most) const {
    const D32 d;
    const int32_t lack_fx16 = vectors_.lack_fx16();
    const V32 raised =
        hn::Add(hn::Min(most, hn::Set(d, INT32_MAX - lack_fx16)), hn::Set(d, lack_fx16));
    const V32 first = hn::ShiftRight<kTexelFraction>(least);
    const V32 last = hn::ShiftRight<kTexelFraction>(raised);
    return {first, hn::Add(hn::Sub(last, first), hn::Set(d, 1))};
  }

  // Of kLanes vectors. Along a row u and v rise or fall all the way.
  HWY_INLINE void find_windows(const HalfAnchors& anchors, int32_t k, PairWindows* found) const {
    const D32 d;
    const RowEnds upper = row_ends(anchors, 0), lower = row_ends(anchors, 1);
    const V32 lack = hn::Set(d, vectors_.lack_fx16());
    const TexelRun s =
        texels_between(hn::Min(upper.least_u, lower.least_u), hn::Max(upper.most_u, lower.most_u));
    const TexelRun t =
        texels_between(hn::Min(upper.least_v, lower.least_v), hn::Max(upper.most_v, lower.most_v));
    const WindowShapes shapes = shapes_of(s.count, t.count, extent_.height_texel);
    const auto origins =
        window_origins<ClampVector>(s.first, t.first, shapes.columns, shapes.rows, extent_);
    // Anchors are less kWholeNumbers, as bits: that is added twice.
    constexpr uint32_t kTwice = 2 * std::bit_cast<uint32_t>(kWholeNumbers);
    const V32 raised = hn::Add(lack, hn::Set(d, static_cast<int32_t>(kTwice)));
    const V32 u_by = hn::Sub(raised, hn::ShiftLeft<kTexelFraction>(origins.s));
    const V32 v_by = hn::Sub(raised, hn::ShiftLeft<kTexelFraction>(origins.t));
    const auto put = [&](V32 anchor, V32 by, float* to) HWY_ATTR {
      const DFloat df;
      hn::StoreU(hn::BitCast(df, hn::Add(anchor, by)), df, to + k);
    };
    put(upper.u_anchor, u_by, found->upper_u);
    put(upper.v_anchor, v_by, found->upper_v);
    put(lower.u_anchor, u_by, found->lower_u);
    put(lower.v_anchor, v_by, found->lower_v);
    hn::StoreU(origins.place, d, found->place + k);
    hn::StoreU(shapes.name, d, found->rows + k);
  }

  const AnchoredVectors& vectors_;
  Extent extent_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
