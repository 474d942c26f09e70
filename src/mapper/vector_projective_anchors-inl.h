// Projective spans in pieces of a vector or some: their anchors. Included once for each SIMD
// target.
//
// Only a piece's first pixel, its anchor, is divided in double, those of several pieces at once.
// With u_0 and d_0 there, the pixel i further on has
//
//     u = u_0 + i / (1 + i turn) * rise,      turn = d' / d_0,  rise = (n' - u_0 d') / d_0,
//
// and what is added to u_0, a few texels, is precise enough in single precision. Lanes are 16.16:
//
//     lane <= true value < lane + lack                              (spec/proofs/anchored_lanes.g)
#if defined(SELVAGE_VECTOR_PROJECTIVE_ANCHORS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_PROJECTIVE_ANCHORS_INL_H
#undef SELVAGE_VECTOR_PROJECTIVE_ANCHORS_INL_H
#else
#define SELVAGE_VECTOR_PROJECTIVE_ANCHORS_INL_H
#endif

#include <bit>

#include "mapper/vector_lanes-inl.h"
#include "mapper/vector_projective_wide-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

using VHalf = hn::Vec<DHalf>;
using DHalfFloat = hn::RebindToFloat<DHalf>;

// So many at once that finding their anchors, which takes long but not much, is done side by side.
inline constexpr int32_t kMostPieces = 16;
static_assert(kMostPieces % kDoubles == 0 && kMostPieces <= kMostLanes);

// Pixels of a row, kMostLanes of them, or the last ones of a span.
inline constexpr int32_t kPiece_px = kMostLanes;
inline constexpr int32_t kVectorsPerPiece = kPiece_px / kLanes;
struct Pieces {
  int32_t count;     // beyond it, values mean nothing
  bool has_windows;  // some piece has window_rows
  int32_t row[kMostPieces], left_px[kMostPieces];
  int32_t right_px[kMostPieces];     // the end of the span
  int32_t window_rows[kMostPieces];  // 0: a load for each pixel

  // Rows of a batch are pieces, from so many pixels right of their first ones on. Some may be
  // empty.
  HWY_INLINE void put_rows(const SpanBatch& batch, int32_t first, int32_t rows,
                           int32_t right_by_px) {
    count = rows;
    has_windows = false;
    const D32 d;
    for (int32_t k = 0; k < kMostPieces; k += kLanes) {
      const V32 left = hn::LoadU(d, batch.left_px.data() + first + k);
      hn::StoreU(hn::Iota(d, batch.first_row + first + k), d, row + k);
      hn::StoreU(hn::Add(left, hn::Set(d, right_by_px)), d, left_px + k);
      hn::StoreU(hn::LoadU(d, batch.right_px.data() + first + k), d, right_px + k);
      hn::StoreU(hn::Zero(d), d, window_rows + k);
    }
  }

  // From one of its vectors on.
  [[nodiscard]] HWY_INLINE Span rest(int32_t k, int32_t vector) const {
    return {row[k], left_px[k] + vector * kLanes, right_px[k]};
  }
};

// The pieces of a batch's spans, some at a time.
class PieceWalk {
 public:
  HWY_INLINE PieceWalk(const ProjectiveSpans& spans, const selvage_texture& texture)
      : spans_(&spans), texture_(&texture) {}

  // False where none is left. Some may be empty.
  HWY_INLINE bool next(Pieces* pieces) {
    return spans_->batch.widest_px <= kPiece_px ? next_rows(pieces) : next_parts(pieces);
  }

 private:
  // Each row is a piece.
  HWY_INLINE bool next_rows(Pieces* pieces) {
    const SpanBatch& batch = spans_->batch;
    if (next_ >= batch.rows) return false;
    pieces->put_rows(batch, next_, HWY_MIN(batch.rows - next_, kMostPieces), 0);
    next_ += kMostPieces;
    return true;
  }

  HWY_INLINE bool next_parts(Pieces* pieces) {
    int32_t count = 0;
    pieces->has_windows = false;
    for (; count < kMostPieces; ++count) {
      while (span_.left_px >= span_.right_px) {
        if (next_ == spans_->batch.rows) {
          pieces->count = count;
          return count != 0;
        }
        span_ = spans_->batch.span(next_++);
        window_rows_ = span_.width_px() < 2 * kLanes ? 0 : rows_of(span_);
      }
      pieces->row[count] = span_.row;
      pieces->left_px[count] = span_.left_px;
      pieces->right_px[count] = span_.right_px;
      pieces->window_rows[count] = window_rows_;
      pieces->has_windows |= window_rows_ != 0;
      span_.left_px += kPiece_px;
    }
    pieces->count = count;
    return true;
  }

  HWY_NOINLINE int32_t rows_of(const Span& span) const {
    return window_rows(spans_->field.of(span), span.width_px(), *texture_);
  }

  const ProjectiveSpans* spans_;
  const selvage_texture* texture_;
  int32_t next_ = 0;
  Span span_{0, 0, 0};
  int32_t window_rows_ = 0;
};

// What the lanes of pieces are made of, in units of 2^-16 texel.
struct Anchors {
  int32_t u_fx16[kMostPieces], v_fx16[kMostPieces];  // less kWholeNumbers, as bits
  float turn[kMostPieces], u_rise[kMostPieces], v_rise[kMostPieces];
};

// Of the windows of pieces.
struct PieceOrigins {
  int32_t index[kVectorsPerPiece][kMostPieces], place[kVectorsPerPiece][kMostPieces];
};

template <class Floats>
[[nodiscard]] HWY_INLINE hn::Vec<Floats> share_of(Floats d, hn::Vec<Floats> i,
                                                  hn::Vec<Floats> turn) {
  return hn::Div(i, hn::MulAdd(i, turn, hn::Set(d, 1.0F)));
}

// The lane after a walk of so much: what is added lands in the lowest bits of a float, a whole
// number.
template <class Floats>
[[nodiscard]] HWY_INLINE auto lane_of(Floats d, hn::Vec<hn::RebindToSigned<Floats>> anchor,
                                      hn::Vec<Floats> share, hn::Vec<Floats> rise) {
  const auto walk = hn::MulAdd(share, rise, hn::Set(d, kWholeNumbers));
  return hn::Add(anchor, hn::BitCast(hn::RebindToSigned<Floats>(), walk));
}

class AnchoredVectors {
 public:
  HWY_INLINE explicit AnchoredVectors(const ProjectiveField& field)
      : u_(scaled(field.u_fx32)),
        v_(scaled(field.v_fx32)),
        denominator_(field.denominator),
        first_px_(field.first_px),
        first_row_(field.first_row),
        lowered_fx16_(anchored_error_fx16(field)) {}

  HWY_INLINE int32_t lack_fx16() const {
    return static_cast<int32_t>(2 * lowered_fx16_) + kAnchoredTruncations_fx16;
  }

  // Of kDoubles pieces from k on.
  HWY_INLINE void find(const Pieces& pieces, int32_t k, Anchors* anchors) const {
    const DD d;
    const DHalf whole;
    const auto from = [&](const int32_t* at, int32_t first) HWY_ATTR {
      return hn::PromoteTo(d, hn::Sub(hn::LoadU(whole, at), hn::Set(whole, first)));
    };
    const VD x = from(pieces.left_px + k, first_px_), y = from(pieces.row + k, first_row_);
    const VD w = hn::Div(hn::Set(d, 1.0), at(denominator_, x, y));
    const VD u = hn::Mul(at(u_, x, y), w), v = hn::Mul(at(v_, x, y), w);
    const VD turn = hn::Mul(hn::Set(d, denominator_.step_x), w);
    store(turn, anchors->turn + k);
    store(hn::NegMulAdd(u, turn, hn::Mul(hn::Set(d, u_.step_x), w)), anchors->u_rise + k);
    store(hn::NegMulAdd(v, turn, hn::Mul(hn::Set(d, v_.step_x), w)), anchors->v_rise + k);
    store_floor(hn::Sub(u, hn::Set(d, lowered_fx16_)), anchors->u_fx16 + k);
    store_floor(hn::Sub(v, hn::Set(d, lowered_fx16_)), anchors->v_fx16 + k);
  }

  // Of kLanes pixels, one of the piece's vectors of them.
  static HWY_INLINE LaneVectors lanes_from(const Anchors& anchors, int32_t k, int32_t vector) {
    const D32 d;
    const hn::RebindToFloat<D32> df;
    const auto i = hn::ConvertTo(df, hn::Iota(d, vector * kLanes));
    const auto share = share_of(df, i, hn::Set(df, anchors.turn[k]));
    return {lane_of(df, hn::Set(d, anchors.u_fx16[k]), share, hn::Set(df, anchors.u_rise[k])),
            lane_of(df, hn::Set(d, anchors.v_fx16[k]), share, hn::Set(df, anchors.v_rise[k]))};
  }

  // Of a vector of kDoubles pieces from k on. Along a span u and v rise or fall all the way: its
  // ends have the least and the most.
  template <class Address>
  static HWY_INLINE void find_origins(const Pieces& pieces, int32_t k, int32_t vector,
                                      const Anchors& anchors, const Extent& extent,
                                      PieceOrigins* origins) {
    const DHalf d;
    const DHalfFloat df;
    const VHalf width_px =
        hn::Sub(hn::LoadU(d, pieces.right_px + k), hn::LoadU(d, pieces.left_px + k));
    const VHalf end = hn::Min(width_px, hn::Set(d, (vector + 1) * kLanes));
    const auto turn = hn::LoadU(df, anchors.turn + k);
    const auto first = share_of(df, hn::Set(df, static_cast<float>(vector * kLanes)), turn);
    const auto last = share_of(df, hn::ConvertTo(df, hn::Sub(end, hn::Set(d, 1))), turn);
    const VHalf s = least_texel(anchors.u_fx16 + k, anchors.u_rise + k, first, last);
    const VHalf t = least_texel(anchors.v_fx16 + k, anchors.v_rise + k, first, last);
    const auto windows =
        window_origins<Address>(s, t, hn::LoadU(d, pieces.window_rows + k), extent);
    hn::StoreU(windows.index, d, origins->index[vector] + k);
    hn::StoreU(windows.place, d, origins->place[vector] + k);
  }

 private:
  using Linear = ProjectiveField::Linear;
  static constexpr double kUnit_fx16 = 1.0 / (1 << (kLaneFraction - kTexelFraction));

  static Linear scaled(const Linear& fx32) {
    return {fx32.start * kUnit_fx16, fx32.step_x * kUnit_fx16, fx32.step_y * kUnit_fx16};
  }
  static HWY_INLINE VD at(const Linear& line, VD x, VD y) {
    const DD d;
    const VD row = hn::MulAdd(y, hn::Set(d, line.step_y), hn::Set(d, line.start));
    return hn::MulAdd(x, hn::Set(d, line.step_x), row);
  }
  static HWY_INLINE void store(VD value, float* to) {
    const hn::Rebind<float, DD> d;
    hn::StoreU(hn::DemoteTo(d, value), d, to);
  }
  static HWY_INLINE void store_floor(VD value, int32_t* to) {
    const DHalf d;
    const VHalf bits = hn::Set(d, std::bit_cast<int32_t>(kWholeNumbers));
    hn::StoreU(hn::Sub(hn::DemoteTo(d, hn::Floor(value)), bits), d, to);
  }
  static HWY_INLINE VHalf least_texel(const int32_t* anchor_fx16, const float* rise,
                                      hn::Vec<DHalfFloat> first, hn::Vec<DHalfFloat> last) {
    const DHalfFloat df;
    const VHalf anchor = hn::LoadU(DHalf(), anchor_fx16);
    const auto steepness = hn::LoadU(df, rise);
    return hn::ShiftRight<kTexelFraction>(
        hn::Min(lane_of(df, anchor, first, steepness), lane_of(df, anchor, last, steepness)));
  }

  Linear u_, v_, denominator_;
  int32_t first_px_, first_row_;
  double lowered_fx16_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
