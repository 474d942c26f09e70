// Stepped rows by vectors. Included once for each SIMD target.
//
// Groups of kStepGroup_px pixels whatever the width of a vector, and no product fused with a sum,
// so that all targets draw the same.
#if defined(SELVAGE_VECTOR_STEPPED_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_STEPPED_KERNEL_INL_H
#undef SELVAGE_VECTOR_STEPPED_KERNEL_INL_H
#else
#define SELVAGE_VECTOR_STEPPED_KERNEL_INL_H
#endif

#include <cmath>

#include "mapper/stepped.h"
#include "mapper/vector_projective_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Eight lanes at most: wider ones were slower to take apart again (AMD Zen).
using DStep = hn::CappedTag<int32_t, 8>;
using VStep = hn::Vec<DStep>;
inline constexpr int32_t kStepLanes = static_cast<int32_t>(hn::MaxLanes(DStep()));
inline constexpr int32_t kStepVectors = kStepGroup_px / kStepLanes;

// floor(i step) for pixel i of a group.
class StepOffsets {
 public:
  explicit HWY_INLINE StepOffsets(int64_t step_fx32) {
    const DStep d;
    const VStep whole = hn::Set(d, static_cast<int32_t>(step_fx32 >> kStepShift));
    const VStep fraction = hn::Set(d, static_cast<int32_t>(step_fx32 & ((1 << kStepShift) - 1)));
    for (int32_t k = 0; k < kStepVectors; ++k) {
      const VStep i = hn::Iota(d, k * kStepLanes);
      offset_fx16_[k] =
          hn::Add(hn::Mul(i, whole), hn::ShiftRight<kStepShift>(hn::Mul(i, fraction)));
    }
  }

  // The texels of vector k of a group whose first pixel has this lane.
  HWY_INLINE VStep texels(int64_t lane_fx32, int32_t k) const {
    const VStep first = hn::Set(DStep(), static_cast<int32_t>(lane_fx32 >> kStepShift));
    return hn::ShiftRight<kTexelFraction>(hn::Add(first, offset_fx16_[k]));
  }

 private:
  VStep offset_fx16_[kStepVectors];
};

template <class Address>
HWY_INLINE void draw_part(const SegmentPart& part, const selvage_texture& texture,
                          const Extent& extent, char* row) {
  const DStep d;
  const StepOffsets u(part.segment.step.u_fx32), v(part.segment.step.v_fx32);
  const int64_t step_u = kStepGroup_px * part.segment.step.u_fx32;
  const int64_t step_v = kStepGroup_px * part.segment.step.v_fx32;
  HWY_ALIGN int32_t place[kStepGroup_px];
  int32_t px = part.group_px();
  Lane lane = part.at(px);
  int32_t skipped = part.left_px - px;
  for (; px < part.right_px; px += kStepGroup_px) {
    for (int32_t k = 0; k < kStepVectors; ++k) {
      const VStep s = u.texels(lane.u_fx32, k), t = v.texels(lane.v_fx32, k);
      hn::Store(Address::place(s, t, extent), d, place + k * kStepLanes);
    }
    const int32_t end = HWY_MIN(part.right_px - px, kStepGroup_px);
    char* const pixel = row + (px + skipped) * bytes_per_pixel(texture.format);
    if (HWY_LIKELY(end - skipped == kStepGroup_px)) {
      fetch(texture, place, kStepGroup_px, pixel);
    } else {
      fetch(texture, place + skipped, end - skipped, pixel);
    }
    skipped = 0;
    lane.u_fx32 += step_u;
    lane.v_fx32 += step_v;
  }
}

// Some segments of a row that follow each other.
class SomeSegments {
 public:
  static constexpr int32_t kMost = 32;

  HWY_INLINE SomeSegments(const SteppedRow& row)
      : u_(row.lanes.u_numerator_fx32(), row.lanes),
        v_(row.lanes.v_numerator_fx32(), row.lanes),
        denominator_(row.lanes.denominator()),
        segment_px_(row.segment_px),
        last_px_(row.last_px()) {}

  // Makes segments [first, first + count) of the row.
  HWY_INLINE void make(int32_t first, int32_t count) {
    const DD d;
    HWY_ALIGN double end_u[kMost + 2 * kDoubles], end_v[kMost + 2 * kDoubles];
    const VD length = hn::Set(d, static_cast<double>(segment_px_));
    const VD last = hn::Set(d, static_cast<double>(last_px_));
    for (int32_t k = 0; k <= count; k += kDoubles) {
      const VD index = hn::Iota(d, static_cast<double>(first + k));
      const VD i = hn::Min(hn::Mul(index, length), last);
      const VD w = hn::Div(hn::Set(d, 1.0), line(denominator_.start, denominator_.step, i));
      hn::Store(quotient(u_, i, w), d, end_u + k);
      hn::Store(quotient(v_, i, w), d, end_v + k);
    }
    const double full = 1.0 / segment_px_;
    for (int32_t k = 0; k < count; k += kDoubles) {
      store(end_u + k, end_u + k + 1, hn::Set(d, full), k, start_u_, whole_u_, part_u_);
      store(end_v + k, end_v + k + 1, hn::Set(d, full), k, start_v_, whole_v_, part_v_);
    }
    const int32_t rest_px = last_px_ - (first + count - 1) * segment_px_;
    if (rest_px < segment_px_) finish(count - 1, rest_px, end_u, end_v);
  }

  // The k-th of those that were made.
  HWY_INLINE Segment at(int32_t k) const {
    const auto fx32 = [](int32_t whole_fx16, int32_t part) {
      return int64_t{whole_fx16} * (1 << kStepShift) + part;
    };
    return {{fx32(start_u_[k], 0), fx32(start_v_[k], 0)},
            {fx32(whole_u_[k], part_u_[k]), fx32(whole_v_[k], part_v_[k])}};
  }

 private:
  static HWY_INLINE VD line(double start, double step, VD i) {
    return hn::Add(hn::Set(DD(), start), hn::Mul(i, hn::Set(DD(), step)));
  }
  static HWY_INLINE VD quotient(const SteppedLine& of, VD i, VD w) {
    return hn::Sub(hn::Mul(line(of.start_fx16, of.step_fx16, i), w), hn::Set(DD(), of.error_fx16));
  }

  // Floors of kDoubles starts, and steps as whole units and 1/65536 of them.
  static HWY_INLINE void store(const double* from, const double* to, VD per_px, int32_t k,
                               int32_t* HWY_RESTRICT start, int32_t* HWY_RESTRICT whole,
                               int32_t* HWY_RESTRICT part) {
    const DD d;
    const DHalf d32;
    const VD a = hn::Load(d, from);
    const VD step = hn::Mul(hn::Sub(hn::LoadU(d, to), a), per_px);
    const VD floor = hn::Floor(step);
    const VD fraction = hn::Mul(hn::Sub(step, floor), hn::Set(d, double{1 << kStepShift}));
    hn::Store(hn::DemoteTo(d32, hn::Floor(a)), d32, start + k);
    hn::Store(hn::DemoteTo(d32, floor), d32, whole + k);
    hn::Store(hn::DemoteTo(d32, fraction), d32, part + k);  // truncated: not negative
  }

  // The row's last segment is shorter, or a single pixel.
  HWY_NOINLINE void finish(int32_t k, int32_t length_px, const double* end_u, const double* end_v) {
    const double per_px = length_px > 0 ? 1.0 / length_px : 0;
    const auto set = [&](const double* end, int32_t* whole, int32_t* part) {
      const double step = (end[k + 1] - end[k]) * per_px;
      const double floor = std::floor(step);
      whole[k] = static_cast<int32_t>(floor);
      part[k] = static_cast<int32_t>((step - floor) * (1 << kStepShift));
    };
    set(end_u, whole_u_, part_u_);
    set(end_v, whole_v_, part_v_);
  }

  SteppedLine u_, v_;
  ProjectiveLanes::Linear denominator_;
  int32_t segment_px_, last_px_;
  HWY_ALIGN int32_t start_u_[kMost], whole_u_[kMost], part_u_[kMost];
  HWY_ALIGN int32_t start_v_[kMost], whole_v_[kMost], part_v_[kMost];
};

template <class Address>
void draw_parts(const SteppedRow& of, const Surface& surface) {
  const selvage_texture texture = surface.texture;
  const Extent extent = extent_of(texture);
  char* const row = static_cast<char*>(surface.target.pixels) + of.span.row * surface.target.pitch;
  SomeSegments segments(of);
  const int32_t end = (of.span.right_px - 1 - of.whole.left_px) / of.segment_px + 1;
  int32_t left_px = of.span.left_px;
  for (int32_t first = of.first_segment(); first < end; first += SomeSegments::kMost) {
    const int32_t count = HWY_MIN(end - first, SomeSegments::kMost);
    segments.make(first, count);
    for (int32_t k = 0; k < count; ++k) {
      const int32_t first_px = of.whole.left_px + (first + k) * of.segment_px;
      const int32_t right_px = HWY_MIN(first_px + of.segment_px, of.span.right_px);
      draw_part<Address>({segments.at(k), first_px, left_px, right_px}, texture, extent, row);
      left_px = right_px;
    }
  }
}

void draw_stepped(const SteppedRow& row, const Surface& surface) {
  with_address(surface, [&](auto address) { draw_parts<decltype(address)>(row, surface); });
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
