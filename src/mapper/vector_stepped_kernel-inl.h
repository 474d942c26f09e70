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

#include <array>
#include <cmath>

#include "mapper/stepped.h"
#include "mapper/vector_lanes-inl.h"
#include "mapper/vector_projective_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// By loads, eight lanes at most: wider ones were slower to take apart again (AMD Zen).
using DStep = hn::CappedTag<int32_t, 8>;

// floor(i step) for pixel i of a group, in units of 2^-16 texel.
template <class D>
class StepOffsets {
 public:
  static constexpr int32_t kLanesOfD = static_cast<int32_t>(hn::MaxLanes(D()));
  static constexpr int32_t kVectors = kStepGroup_px / kLanesOfD;

  explicit HWY_INLINE StepOffsets(int64_t step_fx32)
      : whole_(static_cast<int32_t>(step_fx32 >> kStepShift)),
        fraction_(static_cast<int32_t>(step_fx32 & ((1 << kStepShift) - 1))) {
    const D d;
    for (int32_t k = 0; k < kVectors; ++k) {
      const V i = hn::Iota(d, k * kLanesOfD);
      const V part = hn::ShiftRight<kStepShift>(hn::Mul(i, hn::Set(d, fraction_)));
      offset_fx16_[static_cast<size_t>(k)] = hn::Add(hn::Mul(i, hn::Set(d, whole_)), part);
    }
  }

  // Of vector k of a group whose first pixel has this lane.
  HWY_INLINE hn::Vec<D> lanes(int64_t lane_fx32, int32_t k) const {
    const auto first_fx16 = static_cast<int32_t>(lane_fx32 >> kStepShift);
    return hn::Add(hn::Set(D(), first_fx16), offset_fx16_[static_cast<size_t>(k)]);
  }
  HWY_INLINE hn::Vec<D> texels(int64_t lane_fx32, int32_t k) const {
    return hn::ShiftRight<kTexelFraction>(lanes(lane_fx32, k));
  }
  // The least texel of that vector. It means nothing where a step does not fit windows.
  HWY_INLINE int32_t least_texel(int64_t lane_fx32, int32_t k) const {
    const int32_t i = k * kLanesOfD + (whole_ < 0 ? kLanesOfD - 1 : 0);
    const int32_t offset_fx16 = i * whole_ + ((i * fraction_) >> kStepShift);
    return (static_cast<int32_t>(lane_fx32 >> kStepShift) + offset_fx16) >> kTexelFraction;
  }

 private:
  using V = hn::Vec<D>;
  int32_t whole_, fraction_;
  V offset_fx16_[kVectors];
};

// Groups of a segment by windows.
template <class Pixel, class Address>
class StepWindows {
 public:
  HWY_INLINE StepWindows(const Segment& segment, const selvage_texture& texture)
      : rows_(window_rows(segment.step, texture)),
        u_(segment.step.u_fx32),
        v_(segment.step.v_fx32),
        fixed_(texture, 0),
        extent_(extent_of(texture)),
        texels_(static_cast<const Pixel*>(texture.texels)) {}

  [[nodiscard]] HWY_INLINE bool any() const { return rows_ != 0; }
  // All pixels of the group whose first one has this lane; false where windows do not hold them.
  [[nodiscard]] HWY_INLINE bool draw(Lane lane, Pixel* to) const {
    const int32_t last_column = extent_.width_texel - kLanes;
    const int32_t last_row = extent_.height_texel - rows_;
    for (int32_t k = 0; k < StepOffsets<D32>::kVectors; ++k) {
      const Origin s =
          Address::origin(u_.least_texel(lane.u_fx32, k), last_column, extent_.width_texel);
      const Origin t =
          Address::origin(v_.least_texel(lane.v_fx32, k), last_row, extent_.height_texel);
      if (s.index > last_column || t.index > last_row) return false;
      const LaneVectors lanes{u_.lanes(lane.u_fx32, k), v_.lanes(lane.v_fx32, k)};
      const V32 index =
          fixed_.window_index(lanes, hn::Set(D32(), (t.texel << kWindowColumnBits) + s.texel));
      const Pixel* const window = texels_ + t.index * ptrdiff_t{extent_.pitch_texel} + s.index;
      store_pixels(pick(window, extent_.pitch_texel, rows_, index), kLanes, to + k * kLanes);
    }
    return true;
  }

 private:
  int32_t rows_;
  StepOffsets<D32> u_, v_;
  FixedLanes<Address> fixed_;
  Extent extent_;
  const Pixel* texels_;
};

// Groups of a segment by loads.
template <class Pixel, class Address>
class StepLoads {
 public:
  HWY_INLINE StepLoads(const Segment& segment, const selvage_texture& texture, const Extent& extent)
      : u_(segment.step.u_fx32),
        v_(segment.step.v_fx32),
        texels_(texture.texels),
        extent_(extent) {}

  // The pixels [first, end) of the group whose first one has this lane.
  HWY_INLINE void draw(Lane lane, int32_t first, int32_t end, Pixel* group) const {
    HWY_ALIGN int32_t place[kStepGroup_px];
    for (int32_t k = 0; k < Steps::kVectors; ++k) {
      const auto s = u_.texels(lane.u_fx32, k), t = v_.texels(lane.v_fx32, k);
      hn::Store(Address::place(s, t, extent_), DStep(), place + k * Steps::kLanesOfD);
    }
    char* const pixel = reinterpret_cast<char*>(group + first);
    if (HWY_LIKELY(end - first == kStepGroup_px)) {
      fetch_as<Pixel, kStepGroup_px>(texels_, place, pixel);
    } else {
      fetch_as<Pixel>(texels_, place + first, end - first, pixel);
    }
  }

 private:
  using Steps = StepOffsets<DStep>;
  Steps u_, v_;
  const void* texels_;
  const Extent& extent_;
};

template <class Pixel, class Address>
HWY_INLINE void draw_by_loads(const SegmentPart& part, const selvage_texture& texture,
                              const Extent& extent, Pixel* row) {
  const StepLoads<Pixel, Address> loads(part.segment, texture, extent);
  for (int32_t px = part.group_px(); px < part.right_px; px += kStepGroup_px) {
    loads.draw(part.at(px), HWY_MAX(part.left_px - px, 0),
               HWY_MIN(part.right_px - px, kStepGroup_px), row + px);
  }
}

template <class Pixel, class Address>
HWY_NOINLINE void draw_rest(const SegmentPart& part, const selvage_texture& texture,
                            const Extent& extent, Pixel* row) {
  draw_by_loads<Pixel, Address>(part, texture, extent, row);
}

// By windows as far as they hold whole groups from the left on, and the rest by loads.
template <class Pixel, class Address>
HWY_INLINE void draw_part(const SegmentPart& part, const selvage_texture& texture,
                          const Extent& extent, Pixel* row) {
  if constexpr (!kHasWindows) {
    draw_by_loads<Pixel, Address>(part, texture, extent, row);
  } else {
    const StepWindows<Pixel, Address> windows(part.segment, texture);
    int32_t px = part.left_px;
    if (windows.any() && px == part.group_px()) {
      const int32_t end_px = part.right_px - kStepGroup_px;
      while (px <= end_px && windows.draw(part.at(px), row + px)) px += kStepGroup_px;
    }
    if (px < part.right_px) {
      draw_rest<Pixel, Address>({part.segment, part.first_px, px, part.right_px}, texture, extent,
                                row);
    }
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

  // One of those that were made.
  HWY_INLINE Segment at(int32_t segment) const {
    const auto k = static_cast<size_t>(segment);
    const auto fx32 = [](int32_t whole_fx16, int32_t part) {
      return int64_t{whole_fx16} * (1 << kStepShift) + part;
    };
    return {{fx32(start_u_[k], 0), fx32(start_v_[k], 0)},
            {fx32(whole_u_[k], part_u_[k]), fx32(whole_v_[k], part_v_[k])}};
  }

 private:
  using PerSegment = std::array<int32_t, kMost>;

  static HWY_INLINE VD line(double start, double step, VD i) {
    return hn::Add(hn::Set(DD(), start), hn::Mul(i, hn::Set(DD(), step)));
  }
  static HWY_INLINE VD quotient(const SteppedLine& of, VD i, VD w) {
    return hn::Sub(hn::Mul(line(of.start_fx16, of.step_fx16, i), w), hn::Set(DD(), of.error_fx16));
  }

  // Floors of kDoubles starts, and steps as whole units and 1/65536 of them.
  static HWY_INLINE void store(const double* from, const double* to, VD per_px, int32_t k,
                               PerSegment& start, PerSegment& whole, PerSegment& part) {
    const DD d;
    const DHalf d32;
    const VD a = hn::Load(d, from);
    const VD step = hn::Mul(hn::Sub(hn::LoadU(d, to), a), per_px);
    // As step_fx32() and its parts, all exact: a tiny step below 0 is one of -1 unit too.
    constexpr double kUnits = 1 << kStepShift;
    const VD units = hn::Floor(hn::Mul(step, hn::Set(d, kUnits)));
    const VD floor = hn::Floor(hn::Mul(units, hn::Set(d, 1 / kUnits)));
    const VD fraction = hn::Sub(units, hn::Mul(floor, hn::Set(d, kUnits)));
    hn::Store(hn::DemoteTo(d32, hn::Floor(a)), d32, start.data() + k);
    hn::Store(hn::DemoteTo(d32, floor), d32, whole.data() + k);
    hn::Store(hn::DemoteTo(d32, fraction), d32, part.data() + k);
  }

  // The row's last segment is shorter, or a single pixel.
  HWY_NOINLINE void finish(int32_t k, int32_t length_px, const double* end_u, const double* end_v) {
    const double per_px = length_px > 0 ? 1.0 / length_px : 0;
    const auto set = [&](const double* end, PerSegment& whole, PerSegment& part) {
      const auto units = static_cast<int64_t>(step_fx32((end[k + 1] - end[k]) * per_px));
      whole[static_cast<size_t>(k)] = static_cast<int32_t>(units >> kStepShift);
      part[static_cast<size_t>(k)] = static_cast<int32_t>(units & ((1 << kStepShift) - 1));
    };
    set(end_u, whole_u_, part_u_);
    set(end_v, whole_v_, part_v_);
  }

  SteppedLine u_, v_;
  DividedLanes::Linear denominator_;
  int32_t segment_px_, last_px_;
  HWY_ALIGN PerSegment start_u_, whole_u_, part_u_;
  HWY_ALIGN PerSegment start_v_, whole_v_, part_v_;
};

template <class Pixel, class Address>
void draw_parts(const SteppedRow& of, const Surface& surface) {
  const selvage_texture texture = surface.texture;
  const Extent extent = extent_of(texture);
  Pixel* const row = reinterpret_cast<Pixel*>(first_pixel(surface, {of.span.row, 0, 0}));
  SomeSegments segments(of);
  const int32_t end = (of.span.right_px - 1 - of.whole.left_px) / of.segment_px + 1;
  int32_t left_px = of.span.left_px;
  for (int32_t first = of.first_segment(); first < end; first += SomeSegments::kMost) {
    const int32_t count = HWY_MIN(end - first, SomeSegments::kMost);
    segments.make(first, count);
    for (int32_t k = 0; k < count; ++k) {
      const int32_t first_px = of.whole.left_px + (first + k) * of.segment_px;
      const int32_t right_px = HWY_MIN(first_px + of.segment_px, of.span.right_px);
      draw_part<Pixel, Address>({segments.at(k), first_px, left_px, right_px}, texture, extent,
                                row);
      left_px = right_px;
    }
  }
}

void draw_stepped(const SteppedRow& row, const Surface& surface) {
  with_address(surface, [&](auto address) {
    with_pixel(surface.target.format,
               [&](auto pixel) { draw_parts<decltype(pixel), decltype(address)>(row, surface); });
  });
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
