// Segments of stepped rows, some of them at once. Included once for each SIMD target.
//
// No product is fused with a sum, so that all targets make the same.
#if defined(SELVAGE_VECTOR_STEPPED_SEGMENTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_STEPPED_SEGMENTS_INL_H
#undef SELVAGE_VECTOR_STEPPED_SEGMENTS_INL_H
#else
#define SELVAGE_VECTOR_STEPPED_SEGMENTS_INL_H
#endif

#include <array>
#include <cmath>

#include "mapper/stepped.h"
#include "mapper/vector/lanes-inl.h"
#include "mapper/vector/projective_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// So many at once that making them, which takes long but not much, is done side by side.
inline constexpr int32_t kMostSegments = 16;
static_assert(kMostSegments % kDoubles == 0);

// Of one coordinate: the lanes of first pixels, and steps as whole units and 1/65536 of them.
struct SegmentLanes {
  HWY_ALIGN int32_t start_fx16[kMostSegments], whole_fx16[kMostSegments], part[kMostSegments];

  [[nodiscard]] HWY_INLINE int64_t step_fx32(int32_t k) const {
    return int64_t{whole_fx16[k]} * (1 << kStepShift) + part[k];
  }
};

struct Segments {
  int32_t count;  // beyond it, values mean nothing
  HWY_ALIGN int32_t row[kMostSegments];
  HWY_ALIGN int32_t row_left_px[kMostSegments];  // of the whole row
  // From pixel to pixel, counted from there.
  HWY_ALIGN int32_t first_px[kMostSegments], last_px[kMostSegments];
  // What is to be drawn, counted from the first pixel.
  int32_t from_px[kMostSegments], end_px[kMostSegments];
  SegmentLanes u, v;
};

// The segments of all rows, some at a time: where they are.
class SegmentWalk {
 public:
  HWY_INLINE explicit SegmentWalk(const SteppedSpans& spans) : spans_(spans) {}

  // False where none is left.
  HWY_INLINE bool next(Segments* segments) {
    int32_t count = 0;
    for (; count < kMostSegments; ++count) {
      while (from_px_ >= end_px_) {
        if (next_row_ == spans_.batch.rows) {
          segments->count = count;
          return count != 0;
        }
        go_to(next_row_++);
      }
      segments->row[count] = row_;
      segments->row_left_px[count] = row_left_px_;
      segments->first_px[count] = first_px_;
      segments->last_px[count] = HWY_MIN(first_px_ + segment_px_, last_px_);
      segments->from_px[count] = from_px_ - first_px_;
      segments->end_px[count] = HWY_MIN(segment_px_, end_px_ - first_px_);
      first_px_ += segment_px_;
      from_px_ = first_px_;
    }
    segments->count = count;
    return true;
  }

 private:
  HWY_INLINE void go_to(int32_t i) {
    const Span whole = spans_.whole.span(i), span = spans_.batch.span(i);
    row_ = span.row;
    row_left_px_ = whole.left_px;
    last_px_ = whole.width_px() - 1;
    segment_px_ = spans_.segment_px[i];
    from_px_ = span.left_px - whole.left_px;
    end_px_ = span.right_px - whole.left_px;
    if (from_px_ < end_px_) first_px_ = from_px_ - from_px_ % segment_px_;
  }

  const SteppedSpans& spans_;
  int32_t next_row_ = 0;
  // Of the row, counted from its first pixel.
  int32_t row_ = 0, row_left_px_ = 0, last_px_ = 0, segment_px_ = 0;
  int32_t first_px_ = 0;              // of the next segment
  int32_t from_px_ = 0, end_px_ = 0;  // what is left to be drawn
};

// From where segments are to their lanes.
class SteppedLanes {
 public:
  HWY_INLINE explicit SteppedLanes(const ProjectiveField& field)
      : field_(field), error_fx32_(static_cast<double>(field.error_fx32)) {}

  HWY_INLINE void make(Segments* segments) const {
    const DD d;
    const DHalf whole;
    const auto load = [&](const int32_t* from, int32_t less) HWY_ATTR {
      return hn::PromoteTo(d, hn::Sub(hn::Load(whole, from), hn::Set(whole, less)));
    };
    const VD one = hn::Set(d, 1.0);
    for (int32_t k = 0; k < segments->count; k += kDoubles) {
      const VD x = load(segments->row_left_px + k, field_.first_px);
      const VD y = load(segments->row + k, field_.first_row);
      const VD from = load(segments->first_px + k, 0), to = load(segments->last_px + k, 0);
      const VD per_px = hn::Div(one, hn::Max(hn::Sub(to, from), one));
      const VD q = row_start(field_.denominator, x, y);
      const VD w_from = hn::Div(one, at(field_.denominator, q, from));
      const VD w_to = hn::Div(one, at(field_.denominator, q, to));
      const auto make_lanes = [&](const Form& numerator, SegmentLanes* lanes) HWY_ATTR {
        const VD start = row_start(numerator, x, y);
        const VD a = quotient_fx16(at(numerator, start, from), w_from);
        const VD b = quotient_fx16(at(numerator, start, to), w_to);
        store(hn::Floor(a), lanes->start_fx16 + k);
        store_step(hn::Mul(hn::Sub(b, a), per_px), k, lanes);
      };
      make_lanes(field_.u_fx32, &segments->u);
      make_lanes(field_.v_fx32, &segments->v);
    }
  }

 private:
  using Form = ProjectiveField::Form;

  // As ProjectiveField::of().
  static HWY_INLINE VD row_start(const Form& line, VD x, VD y) {
    const DD d;
    const VD row = hn::Add(hn::Set(d, line.start), hn::Mul(y, hn::Set(d, line.step_y)));
    return hn::Add(row, hn::Mul(x, hn::Set(d, line.step_x)));
  }
  static HWY_INLINE VD at(const Form& line, VD start, VD px) {
    return hn::Add(start, hn::Mul(px, hn::Set(DD(), line.step_x)));
  }
  HWY_INLINE VD quotient_fx16(VD numerator_fx32, VD w) const {
    const DD d;
    const VD low_fx32 = hn::Sub(hn::Mul(numerator_fx32, w), hn::Set(d, error_fx32_));
    return hn::Mul(low_fx32, hn::Set(d, kStepUnit_fx16));
  }
  static HWY_INLINE void store(VD whole, int32_t* to) {
    hn::Store(hn::DemoteTo(DHalf(), whole), DHalf(), to);
  }
  // As step_fx32() and its parts, all exact: a tiny step below 0 is one of -1 unit too.
  static HWY_INLINE void store_step(VD step_fx16, int32_t k, SegmentLanes* lanes) {
    const DD d;
    const VD units = hn::Floor(hn::Mul(step_fx16, hn::Set(d, 1 / kStepUnit_fx16)));
    const VD floor = hn::Floor(hn::Mul(units, hn::Set(d, kStepUnit_fx16)));
    store(floor, lanes->whole_fx16 + k);
    store(hn::Sub(units, hn::Mul(floor, hn::Set(d, 1 / kStepUnit_fx16))), lanes->part + k);
  }

  const ProjectiveField& field_;
  double error_fx32_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
