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

#include "mapper/vector/lanes-inl.h"
#include "mapper/vector/piece_walk-inl.h"
#include "mapper/vector/projective_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

using VHalf = hn::Vec<DHalf>;
using DHalfFloat = hn::RebindToFloat<DHalf>;
using VHalfFloat = hn::Vec<DHalfFloat>;
using DFloat = hn::RebindToFloat<D32>;
using VFloat = hn::Vec<DFloat>;

// What the lanes of pieces are made of, in units of 2^-16 texel.
struct Anchors {
  int32_t u_fx16[kMostPieces], v_fx16[kMostPieces];  // less kWholeNumbers, as bits
  float turn[kMostPieces], u_rise[kMostPieces], v_rise[kMostPieces];
};

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
      : AnchoredVectors(field, anchored_error_fx16(field)) {}
  HWY_INLINE AnchoredVectors(const ProjectiveField& field, double lowered_fx16)
      : u_(scaled(field.u_fx32)),
        v_(scaled(field.v_fx32)),
        denominator_(field.denominator),
        is_ruled_(field.is_ruled),
        first_px_(field.first_px),
        first_row_(field.first_row),
        lowered_fx16_(lowered_fx16) {}

  [[nodiscard]] HWY_INLINE PieceLanes lanes() const { return PieceLanes(constants_); }
  HWY_INLINE int32_t lack_fx16() const {
    return static_cast<int32_t>(2 * lowered_fx16_) + kAnchoredTruncations_fx16;
  }

  // u and v of kDoubles pixels, each off by less than the field's error, not lowered.
  struct Estimates {
    VD u_fx16, v_fx16;
  };
  HWY_INLINE Estimates estimates(VHalf px, VHalf row) const {
    const Fractions at = fractions(px, row);
    return {at.u, at.v};
  }

  // The anchors at kDoubles pixels.
  struct HalfAnchors {
    VHalf u_fx16, v_fx16;  // less kWholeNumbers, as bits
    VHalfFloat turn, u_rise, v_rise;
  };
  HWY_INLINE HalfAnchors at(VHalf px, VHalf row) const {
    const Fractions at = fractions(px, row);
    const VD turn = hn::Mul(at.denominator_step, at.w);
    return {whole_less_bits(at.u), whole_less_bits(at.v), narrow(turn),
            narrow(hn::NegMulAdd(at.u, turn, hn::Mul(at.u_step, at.w))),
            narrow(hn::NegMulAdd(at.v, turn, hn::Mul(at.v_step, at.w)))};
  }

  // Of kDoubles pieces from k on, counted from a texel.
  HWY_INLINE void find(const Pieces& pieces, int32_t k, Lane origin, Anchors* anchors) const {
    const DHalf d;
    const DHalfFloat df;
    const HalfAnchors half = half_from(pieces, k);
    const auto u_fx16 = hn::Sub(half.u_fx16, hn::Set(d, floor_fx16(origin.u_fx32)));
    const auto v_fx16 = hn::Sub(half.v_fx16, hn::Set(d, floor_fx16(origin.v_fx32)));
    hn::StoreU(u_fx16, d, anchors->u_fx16 + k);
    hn::StoreU(v_fx16, d, anchors->v_fx16 + k);
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

 private:
  using Form = ProjectiveField::Form;
  static constexpr double kUnit_fx16 = 1.0 / (1 << (kLaneFraction - kTexelFraction));

  static Form scaled(const Form& fx32) {
    return {fx32.start * kUnit_fx16, fx32.step_x * kUnit_fx16, fx32.step_y * kUnit_fx16,
            fx32.step_xy * kUnit_fx16, fx32.step_yy * kUnit_fx16};
  }
  // The values of a form, and their steps to the right.
  struct Values {
    VD at, step;
  };
  HWY_INLINE Values values(const Form& form, VD x, VD y) const {
    const DD d;
    VD step_x = hn::Set(d, form.step_x), step_y = hn::Set(d, form.step_y);
    if (is_ruled_) {
      step_x = hn::MulAdd(y, hn::Set(d, form.step_xy), step_x);
      step_y = hn::MulAdd(y, hn::Set(d, form.step_yy), step_y);
    }
    const VD row = hn::MulAdd(y, step_y, hn::Set(d, form.start));
    return {hn::MulAdd(x, step_x, row), step_x};
  }
  // u and v, the steps of their numerators and of the denominator, and 1 over that.
  struct Fractions {
    VD u, v, u_step, v_step, denominator_step, w;
  };
  HWY_INLINE Fractions fractions(VHalf px, VHalf row) const {
    const DD d;
    const auto from = [&](VHalf at, int32_t first) HWY_ATTR {
      return hn::PromoteTo(d, hn::Sub(at, hn::Set(DHalf(), first)));
    };
    const VD x = from(px, first_px_), y = from(row, first_row_);
    const Values n_u = values(u_, x, y), n_v = values(v_, x, y);
    const Values denominator = values(denominator_, x, y);
    const VD w = hn::Div(hn::Set(d, 1.0), denominator.at);
    return {hn::Mul(n_u.at, w), hn::Mul(n_v.at, w), n_u.step, n_v.step, denominator.step, w};
  }
  HWY_INLINE HalfAnchors half_from(const Pieces& pieces, int32_t k) const {
    const DHalf d;
    return at(hn::LoadU(d, pieces.left_px + k), hn::LoadU(d, pieces.row + k));
  }
  static HWY_INLINE VHalfFloat narrow(VD value) { return hn::DemoteTo(DHalfFloat(), value); }
  // The anchor's lane of a value, less kWholeNumbers, as bits.
  HWY_INLINE VHalf whole_less_bits(VD value) const {
    const DHalf d;
    const VHalf bits = hn::Set(d, std::bit_cast<int32_t>(kWholeNumbers));
    const VD low = hn::Sub(value, hn::Set(DD(), lowered_fx16_));
    return hn::Sub(hn::DemoteTo(d, hn::Floor(low)), bits);
  }

  Form u_, v_, denominator_;
  bool is_ruled_;
  int32_t first_px_, first_row_;
  double lowered_fx16_;
  WalkConstants constants_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
