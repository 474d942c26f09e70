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
using VHalfFloat = hn::Vec<DHalfFloat>;
using DFloat = hn::RebindToFloat<D32>;
using VFloat = hn::Vec<DFloat>;

// So many at once that finding their anchors, which takes long but not much, is done side by side.
inline constexpr int32_t kMostPieces = kLanes == kMostLanes ? 32 : 16;
static_assert(kMostPieces % kLanes == 0);

// Pixels of a row, kMostLanes of them, or the last ones of a span.
inline constexpr int32_t kPiece_px = kMostLanes;
inline constexpr int32_t kVectorsPerPiece = kPiece_px / kLanes;
struct Pieces {
  int32_t count;  // beyond it, values mean nothing
  int32_t row[2 * kMostPieces], left_px[2 * kMostPieces];
  int32_t right_px[2 * kMostPieces];  // the end of the span
  int64_t to_byte[2 * kMostPieces];   // of the target: set by PieceWalk alone

  // Rows of a batch are pieces, from so many pixels right of their first ones on. Some may be
  // empty.
  HWY_INLINE void put_rows(const SpanBatch& batch, int32_t first, int32_t rows,
                           int32_t right_by_px) {
    count = rows;
    const D32 d;
    for (int32_t k = 0; k < rows; k += kLanes) {
      const V32 left = hn::LoadU(d, batch.left_px.data() + first + k);
      hn::StoreU(hn::Iota(d, batch.first_row + first + k), d, row + k);
      hn::StoreU(hn::Add(left, hn::Set(d, right_by_px)), d, left_px + k);
      hn::StoreU(hn::LoadU(d, batch.right_px.data() + first + k), d, right_px + k);
    }
  }

  // The first pieces of a span, up to kMostPieces of them in all. Returns what is left of it.
  HWY_INLINE Span add(const Span& span) {
    const D32 d;
    const int32_t pieces =
        HWY_MIN((span.width_px() + kPiece_px - 1) / kPiece_px, kMostPieces - count);
    for (int32_t k = 0; k < pieces; k += kLanes) {
      const V32 first_px = hn::Mul(hn::Iota(d, k), hn::Set(d, kPiece_px));
      hn::StoreU(hn::Set(d, span.row), d, row + count + k);
      hn::StoreU(hn::Add(first_px, hn::Set(d, span.left_px)), d, left_px + count + k);
      hn::StoreU(hn::Set(d, span.right_px), d, right_px + count + k);
    }
    count += pieces;
    return {span.row, span.left_px + pieces * kPiece_px, span.right_px};
  }

  // From one of its vectors on.
  [[nodiscard]] HWY_INLINE Span rest(int32_t k, int32_t vector) const {
    return {row[k], left_px[k] + vector * kLanes, right_px[k]};
  }
};

// The pieces of a batch's spans, some at a time.
class PieceWalk {
 public:
  HWY_INLINE PieceWalk(const SpanBatch& batch, const selvage_image& target)
      : batch_(&batch), pitch_(target.pitch), pixel_bytes_(bytes_per_pixel(target.format)) {
    for (int32_t k = 0; k < kMostPieces; ++k) bytes_[k] = k * kPiece_px * pixel_bytes_;
  }

  // None where none is left. Some may be empty.
  HWY_INLINE void next(Pieces* pieces) {
    if (batch_->widest_px <= kPiece_px) {
      next_rows(pieces);
    } else {
      next_parts(pieces);
    }
  }

 private:
  // Each row is a piece.
  HWY_INLINE void next_rows(Pieces* pieces) {
    const int32_t rows = HWY_MIN(batch_->rows - next_, kMostPieces);
    pieces->put_rows(*batch_, next_, rows, 0);
    for (int32_t k = 0; k < rows; ++k) {
      pieces->to_byte[k] = first_byte({pieces->row[k], pieces->left_px[k], 0});
    }
    next_ += rows;
  }

  HWY_INLINE void next_parts(Pieces* pieces) {
    pieces->count = 0;
    while (pieces->count < kMostPieces) {
      if (span_.left_px >= span_.right_px) {
        if (next_ == batch_->rows) break;
        span_ = batch_->span(next_++);
      }
      const hn::Repartition<int64_t, D32> d;
      const auto first = hn::Set(d, first_byte(span_));
      int64_t* const to_byte = pieces->to_byte + pieces->count;
      span_ = pieces->add(span_);
      const int64_t* const end = pieces->to_byte + pieces->count;
      for (int32_t k = 0; to_byte + k < end; k += kLanes / 2) {
        hn::StoreU(hn::Add(first, hn::LoadU(d, bytes_ + k)), d, to_byte + k);
      }
    }
  }

  [[nodiscard]] HWY_INLINE int64_t first_byte(const Span& span) const {
    return span.row * pitch_ + span.left_px * pixel_bytes_;
  }

  const SpanBatch* batch_;
  int64_t pitch_, pixel_bytes_;
  int64_t bytes_[kMostPieces];  // from a span's first piece on
  int32_t next_ = 0;
  Span span_{0, 0, 0};
};

// What the lanes of pieces are made of, in units of 2^-16 texel.
struct Anchors {
  int32_t u_fx16[kMostPieces], v_fx16[kMostPieces];  // less kWholeNumbers, as bits
  float turn[kMostPieces], u_rise[kMostPieces], v_rise[kMostPieces];
};

// The windows of vectors of pieces: the lanes of the piece's anchor counted from there, less
// kWholeNumbers, as bits; their places; and rows. Where they are kHalfWindow, half as many columns
// are enough; where kNoWindow, it does not lie in the texture; where 0, there is a load for each
// pixel.
struct PieceWindows {
  int32_t u_fx16[kVectorsPerPiece][kMostPieces], v_fx16[kVectorsPerPiece][kMostPieces];
  int32_t place[kVectorsPerPiece][kMostPieces], rows[kVectorsPerPiece][kMostPieces] = {};
};
inline constexpr int32_t kHalfWindow = -1, kNoWindow = -2;

template <class Floats>
[[nodiscard]] HWY_INLINE hn::Vec<Floats> share_of(Floats d, hn::Vec<Floats> i,
                                                  hn::Vec<Floats> turn) {
  return hn::Div(i, hn::MulAdd(i, turn, hn::Set(d, 1.0F)));
}

// A walk of so much, to be added to an anchor: it lands in the lowest bits of a float, a whole
// number.
template <class Floats>
[[nodiscard]] HWY_INLINE auto walk_of(Floats d, hn::Vec<Floats> share, hn::Vec<Floats> rise) {
  const auto walk = hn::MulAdd(share, rise, hn::Set(d, kWholeNumbers));
  return hn::BitCast(hn::RebindToSigned<Floats>(), walk);
}

// The constants of walks from anchors. They come from memory: where a compiler knows them, it loads
// them for each vector anew, and does not keep them in registers.
struct WalkConstants {
  float steps[kPiece_px], one = 1, whole = kWholeNumbers;

  HWY_INLINE WalkConstants() {
    for (int32_t i = 0; i < kPiece_px; ++i) steps[i] = static_cast<float>(i);
  }
};

// From the anchors of pieces to the lanes of pixels.
class PieceLanes {
 public:
  HWY_INLINE PieceLanes()
      : one_(hn::Set(DFloat(), 1.0F)), whole_(hn::Set(DFloat(), kWholeNumbers)) {
    for (int32_t at = 0; at < kVectorsPerPiece; ++at) {
      steps_[at] = hn::ConvertTo(DFloat(), hn::Iota(D32(), at * kLanes));
    }
  }
  HWY_INLINE explicit PieceLanes(const WalkConstants& constants)
      : one_(hn::Set(DFloat(), constants.one)), whole_(hn::Set(DFloat(), constants.whole)) {
    for (int32_t at = 0; at < kVectorsPerPiece; ++at) {
      steps_[at] = hn::LoadU(DFloat(), constants.steps + at * kLanes);
    }
  }

  // What is added to the lanes of the anchor, of one of a piece's vectors of pixels.
  HWY_INLINE LaneVectors walk(const Anchors& anchors, int32_t k, int32_t vector) const {
    const D32 d;
    const DFloat df;
    const VFloat i = steps_[vector];
    const VFloat share = hn::Div(i, hn::MulAdd(i, hn::Set(df, anchors.turn[k]), one_));
    return {hn::BitCast(d, hn::MulAdd(share, hn::Set(df, anchors.u_rise[k]), whole_)),
            hn::BitCast(d, hn::MulAdd(share, hn::Set(df, anchors.v_rise[k]), whole_))};
  }
  HWY_INLINE LaneVectors lanes(const Anchors& anchors, int32_t k, int32_t vector) const {
    return plus(walk(anchors, k, vector), anchors.u_fx16[k], anchors.v_fx16[k]);
  }
  static HWY_INLINE LaneVectors plus(const LaneVectors& walk, int32_t u_fx16, int32_t v_fx16) {
    const D32 d;
    return {hn::Add(hn::Set(d, u_fx16), walk.u), hn::Add(hn::Set(d, v_fx16), walk.v)};
  }

 private:
  VFloat steps_[kVectorsPerPiece], one_, whole_;
};

class AnchoredVectors {
 public:
  HWY_INLINE explicit AnchoredVectors(const ProjectiveField& field)
      : u_(scaled(field.u_fx32)),
        v_(scaled(field.v_fx32)),
        denominator_(field.denominator),
        first_px_(field.first_px),
        first_row_(field.first_row),
        lowered_fx16_(anchored_error_fx16(field)) {}

  [[nodiscard]] HWY_INLINE PieceLanes lanes() const { return PieceLanes(constants_); }
  HWY_INLINE int32_t lack_fx16() const {
    return static_cast<int32_t>(2 * lowered_fx16_) + kAnchoredTruncations_fx16;
  }

  // Of kDoubles pieces from k on.
  HWY_INLINE void find(const Pieces& pieces, int32_t k, Anchors* anchors) const {
    const DHalf d;
    const DHalfFloat df;
    const HalfAnchors half = half_from(pieces, k);
    hn::StoreU(half.u_fx16, d, anchors->u_fx16 + k);
    hn::StoreU(half.v_fx16, d, anchors->v_fx16 + k);
    hn::StoreU(half.turn, df, anchors->turn + k);
    hn::StoreU(half.u_rise, df, anchors->u_rise + k);
    hn::StoreU(half.v_rise, df, anchors->v_rise + k);
  }

  // Of kLanes pieces from k on.
  HWY_INLINE void find_lanes(const Pieces& pieces, int32_t k, Anchors* anchors) const {
    const D32 d;
    const DFloat df;
    const HalfAnchors low = half_from(pieces, k), high = half_from(pieces, k + kDoubles);
    hn::StoreU(hn::Combine(d, high.u_fx16, low.u_fx16), d, anchors->u_fx16 + k);
    hn::StoreU(hn::Combine(d, high.v_fx16, low.v_fx16), d, anchors->v_fx16 + k);
    hn::StoreU(hn::Combine(df, high.turn, low.turn), df, anchors->turn + k);
    hn::StoreU(hn::Combine(df, high.u_rise, low.u_rise), df, anchors->u_rise + k);
    hn::StoreU(hn::Combine(df, high.v_rise, low.v_rise), df, anchors->v_rise + k);
  }

  // Of one vector of kLanes pieces from k on. Along a span u and v rise or fall all the way: its
  // ends have the least and the most.
  template <class Address, int32_t kVector>
  static HWY_INLINE void find_windows(const Pieces& pieces, int32_t k, const Anchors& anchors,
                                      const Extent& extent, PieceWindows* windows) {
    const D32 d;
    const DFloat df;
    const V32 width_px =
        hn::Sub(hn::LoadU(d, pieces.right_px + k), hn::LoadU(d, pieces.left_px + k));
    const V32 end = hn::Min(width_px, hn::Set(d, (kVector + 1) * kLanes));
    const VFloat turn = hn::LoadU(df, anchors.turn + k);
    const auto first = kVector == 0
                           ? hn::Zero(df)
                           : share_of(df, hn::Set(df, static_cast<float>(kVector * kLanes)), turn);
    const auto last = share_of(df, hn::ConvertTo(df, hn::Sub(end, hn::Set(d, 1))), turn);
    const V32 u = hn::LoadU(d, anchors.u_fx16 + k), v = hn::LoadU(d, anchors.v_fx16 + k);
    const TexelRun s = run_of(u, hn::LoadU(df, anchors.u_rise + k), first, last);
    const TexelRun t = run_of(v, hn::LoadU(df, anchors.v_rise + k), first, last);

    constexpr int32_t kHalfColumns = kColumns<kHalfColumnBits>;
    const bool has_half = extent.height_texel >= kHalfWindowRows;
    const auto is_half = hn::And(hn::Lt(s.count, hn::Set(d, has_half ? kHalfColumns + 1 : 0)),
                                 hn::Lt(t.count, hn::Set(d, kHalfWindowRows + 1)));
    const V32 columns = hn::IfThenElse(is_half, hn::Set(d, kHalfColumns), hn::Set(d, kLanes));
    const V32 rows = hn::IfThenElse(is_half, hn::Set(d, kHalfWindowRows), whole_rows(t.count));
    const int32_t most_rows = HWY_MIN(kMostWindowRows, extent.height_texel);
    const auto none = hn::Or(hn::Gt(s.count, columns), hn::Gt(rows, hn::Set(d, most_rows)));
    const auto origins = window_origins<Address>(s.first, t.first, columns, rows, extent);
    const auto from = [&](V32 anchor_fx16, V32 texel) HWY_ATTR {
      return hn::Sub(anchor_fx16, hn::ShiftLeft<kTexelFraction>(texel));
    };
    hn::StoreU(from(u, origins.s), d, windows->u_fx16[kVector] + k);
    hn::StoreU(from(v, origins.t), d, windows->v_fx16[kVector] + k);
    hn::StoreU(origins.place, d, windows->place[kVector] + k);
    const V32 in_texture = hn::IfThenElse(is_half, hn::Set(d, kHalfWindow), rows);
    const V32 shape =
        hn::IfThenElse(hn::Lt(origins.place, hn::Zero(d)), hn::Set(d, kNoWindow), in_texture);
    hn::StoreU(hn::IfThenZeroElse(none, shape), d, windows->rows[kVector] + k);
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
  struct HalfAnchors {
    VHalf u_fx16, v_fx16;
    VHalfFloat turn, u_rise, v_rise;
  };
  HWY_INLINE HalfAnchors half_from(const Pieces& pieces, int32_t k) const {
    const DD d;
    const DHalf whole;
    const auto from = [&](const int32_t* at, int32_t first) HWY_ATTR {
      return hn::PromoteTo(d, hn::Sub(hn::LoadU(whole, at), hn::Set(whole, first)));
    };
    const VD x = from(pieces.left_px + k, first_px_), y = from(pieces.row + k, first_row_);
    const VD w = hn::Div(hn::Set(d, 1.0), at(denominator_, x, y));
    const VD u = hn::Mul(at(u_, x, y), w), v = hn::Mul(at(v_, x, y), w);
    const VD turn = hn::Mul(hn::Set(d, denominator_.step_x), w);
    return {whole_less_bits(u), whole_less_bits(v), narrow(turn),
            narrow(hn::NegMulAdd(u, turn, hn::Mul(hn::Set(d, u_.step_x), w))),
            narrow(hn::NegMulAdd(v, turn, hn::Mul(hn::Set(d, v_.step_x), w)))};
  }
  static HWY_INLINE VHalfFloat narrow(VD value) { return hn::DemoteTo(DHalfFloat(), value); }
  // The anchor's lane of a value, less kWholeNumbers, as bits.
  HWY_INLINE VHalf whole_less_bits(VD value) const {
    const DHalf d;
    const VHalf bits = hn::Set(d, std::bit_cast<int32_t>(kWholeNumbers));
    const VD low = hn::Sub(value, hn::Set(DD(), lowered_fx16_));
    return hn::Sub(hn::DemoteTo(d, hn::Floor(low)), bits);
  }

  // Texels from the first one on, at most as many as that: two no further apart than n are in n
  // rounded up, plus one.
  struct TexelRun {
    V32 first, count;
  };
  static HWY_INLINE TexelRun run_of(V32 anchor_fx16, VFloat rise, VFloat first, VFloat last) {
    const D32 d;
    const DFloat df;
    const V32 from = hn::Add(anchor_fx16, walk_of(df, first, rise));
    const V32 to = hn::Add(anchor_fx16, walk_of(df, last, rise));
    constexpr int32_t kOne = 1 << kTexelFraction;
    const V32 apart = hn::Add(hn::Abs(hn::Sub(to, from)), hn::Set(d, 2 * kOne - 1));
    return {hn::ShiftRight<kTexelFraction>(hn::Min(from, to)),
            hn::ShiftRight<kTexelFraction>(apart)};
  }

  Linear u_, v_, denominator_;
  int32_t first_px_, first_row_;
  double lowered_fx16_;
  WalkConstants constants_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
