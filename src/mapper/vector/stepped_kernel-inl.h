// Stepped rows by vectors. Included once for each SIMD target.
//
// Groups of kStepGroup_px pixels whatever the width of a vector, so that all targets draw the same.
#if defined(SELVAGE_VECTOR_STEPPED_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_STEPPED_KERNEL_INL_H
#undef SELVAGE_VECTOR_STEPPED_KERNEL_INL_H
#else
#define SELVAGE_VECTOR_STEPPED_KERNEL_INL_H
#endif

#include "mapper/vector/entries-inl.h"
#include "mapper/vector/fetch-inl.h"
#include "mapper/vector/stepped_segments-inl.h"
#include "mapper/vector/store-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// The first pixel of a segment, visible or not.
template <class Pixel>
[[nodiscard]] HWY_INLINE Pixel* first_of(const Segments& segments, int32_t k,
                                         const Surface& surface) {
  char* const row =
      static_cast<char*>(surface.target.pixels) + segments.row[k] * surface.target.pitch;
  return reinterpret_cast<Pixel*>(row) + segments.row_left_px[k] + segments.first_px[k];
}

// By loads, eight lanes at most: wider ones were slower to take apart again (AMD Zen).
using DStep = hn::CappedTag<int32_t, 8>;

// Lanes of one coordinate of a segment, in units of 2^-16 texel.
template <class D>
class StepLanes {
 public:
  static constexpr int32_t kLanesOfD = static_cast<int32_t>(hn::MaxLanes(D()));
  static constexpr int32_t kVectors = kStepGroup_px / kLanesOfD;

  HWY_INLINE StepLanes(const SegmentLanes& lanes, int32_t segment)
      : start_fx16_(lanes.start_fx16[segment]),
        whole_(lanes.whole_fx16[segment]),
        part_(lanes.part[segment]) {
    for (int32_t k = 0; k < kVectors; ++k) {
      offset_fx16_[k] = after(hn::Iota(D(), k * kLanesOfD));
    }
  }

  // Of groups' first pixels, so many steps from the segment's, modulo 2^32.
  HWY_INLINE hn::Vec<D> groups(hn::Vec<D> steps) const {
    return hn::Add(hn::Set(D(), start_fx16_), after(steps));
  }
  HWY_INLINE int32_t group(int32_t steps) const {
    const int64_t step_fx32 = int64_t{whole_} * (1 << kStepShift) + part_;
    return static_cast<int32_t>(start_fx16_ + (steps * step_fx32 >> kStepShift));
  }
  // Of vector k of a group whose first pixel has this lane.
  HWY_INLINE hn::Vec<D> pixels(int32_t group_fx16, int32_t k) const {
    return hn::Add(hn::Set(D(), group_fx16), offset_fx16_[k]);
  }
  // The least offset of vector k from the group's first pixel: that of its first lane, or its last.
  HWY_INLINE hn::Vec<D> least_offset(int32_t k) const {
    const D d;
    const auto lane = [&](int32_t i) HWY_ATTR {
      return hn::TableLookupLanes(offset_fx16_[k], hn::IndicesFromVec(d, hn::Set(d, i)));
    };
    return hn::Min(lane(0), lane(kLanesOfD - 1));
  }

 private:
  // floor(steps times step); there are less than 2^16 of them.
  HWY_INLINE hn::Vec<D> after(hn::Vec<D> steps) const {
    const D d;
    const auto parts = hn::BitCast(hn::RebindToUnsigned<D>(), hn::Mul(steps, hn::Set(d, part_)));
    return hn::Add(hn::Mul(steps, hn::Set(d, whole_)),
                   hn::BitCast(d, hn::ShiftRight<kStepShift>(parts)));
  }

  int32_t start_fx16_, whole_, part_;
  hn::Vec<D> offset_fx16_[kVectors];
};

// What windows are drawn from, and how.
template <class Pixel, class Address>
struct WindowSource {
  FixedLanes<Address> fixed;
  Extent extent;
  const Pixel* texels;

  HWY_INLINE explicit WindowSource(const selvage_texture& texture)
      : fixed(texture, 0),
        extent(extent_of(texture)),
        texels(static_cast<const Pixel*>(texture.texels)) {}
};

// A segment by windows, which begin at the places of so many groups at once.
template <class Pixel, class Address>
class StepWindows {
 public:
  using Source = WindowSource<Pixel, Address>;

  HWY_INLINE StepWindows(const Segments& segments, int32_t segment, int32_t rows,
                         const Source& source)
      : source_(source), rows_(rows), u_(segments.u, segment), v_(segments.v, segment) {}

  // Draws the pixels [from, end) of the segment, the first one a group's. Returns where windows do
  // not hold a group, or the end.
  HWY_INLINE int32_t draw(int32_t from_px, int32_t end_px, Pixel* segment) const {
    Groups groups;
    for (int32_t px = from_px; px < end_px; px += kLanes * kStepGroup_px) {
      find(px, &groups);
      for (int32_t i = 0; i < kLanes && px + i * kStepGroup_px < end_px; ++i) {
        const int32_t at_px = px + i * kStepGroup_px;
        if (!draw_group(groups, i, end_px - at_px, segment + at_px)) return at_px;
      }
    }
    return end_px;
  }

 private:
  using Lanes = StepLanes<D32>;
  struct Groups {
    // Counted from the windows of their vectors.
    HWY_ALIGN int32_t u_fx16[Lanes::kVectors][kLanes], v_fx16[Lanes::kVectors][kLanes];
    HWY_ALIGN int32_t place[Lanes::kVectors][kLanes];
  };

  HWY_INLINE void find(int32_t px, Groups* groups) const {
    const D32 d;
    const V32 steps = hn::Add(hn::Mul(hn::Iota(d, 0), hn::Set(d, kStepGroup_px)), hn::Set(d, px));
    const V32 u = u_.groups(steps), v = v_.groups(steps);
    for (int32_t k = 0; k < Lanes::kVectors; ++k) {
      const V32 s = hn::ShiftRight<kTexelFraction>(hn::Add(u, u_.least_offset(k)));
      const V32 t = hn::ShiftRight<kTexelFraction>(hn::Add(v, v_.least_offset(k)));
      const auto windows =
          window_origins<Address>(s, t, hn::Set(d, kLanes), hn::Set(d, rows_), source_.extent);
      hn::Store(hn::Sub(u, hn::ShiftLeft<kTexelFraction>(windows.s)), d, groups->u_fx16[k]);
      hn::Store(hn::Sub(v, hn::ShiftLeft<kTexelFraction>(windows.t)), d, groups->v_fx16[k]);
      hn::Store(windows.place, d, groups->place[k]);
    }
  }

  // The first pixels of a group, or all.
  [[nodiscard]] HWY_INLINE bool draw_group(const Groups& groups, int32_t i, int32_t count,
                                           Pixel* to) const {
    for (int32_t k = 0; k < Lanes::kVectors && k * kLanes < count; ++k) {
      const int32_t place = groups.place[k][i];
      if (HWY_UNLIKELY(place == kNoPlace)) return false;
      const LaneVectors lanes{u_.pixels(groups.u_fx16[k][i], k), v_.pixels(groups.v_fx16[k][i], k)};
      const V32 index = source_.fixed.template window_index<kWindowColumnBits>(lanes, rows_);
      store_pixels(pick_few(source_.texels + place, source_.extent.pitch_texel, rows_, index),
                   count - k * kLanes, to + k * kLanes);
    }
    return true;
  }

  const Source& source_;
  int32_t rows_;
  Lanes u_, v_;
};

// Groups of a segment by loads.
template <class Pixel, class Address>
class StepLoads {
 public:
  HWY_INLINE StepLoads(const Segments& segments, int32_t segment, const selvage_texture& texture)
      : u_(segments.u, segment),
        v_(segments.v, segment),
        extent_(extent_of(texture)),
        texels_(texture.texels) {}

  // The pixels [from, end) of the segment.
  HWY_INLINE void draw(int32_t from_px, int32_t end_px, Pixel* segment) const {
    int32_t skipped = from_px % kStepGroup_px;
    for (int32_t px = from_px - skipped; px < end_px; px += kStepGroup_px) {
      HWY_ALIGN int32_t place[kStepGroup_px];
      find(u_.group(px), v_.group(px), place);
      const int32_t count = HWY_MIN(end_px - px, kStepGroup_px) - skipped;
      char* const to = reinterpret_cast<char*>(segment + px + skipped);
      if (HWY_LIKELY(count == kStepGroup_px)) {
        fetch_as<Pixel, kStepGroup_px>(texels_, place, to);
      } else {
        fetch_as<Pixel>(texels_, place + skipped, count, to);
      }
      skipped = 0;
    }
  }

 private:
  using Lanes = StepLanes<DStep>;

  HWY_INLINE void find(int32_t u_fx16, int32_t v_fx16, int32_t* place) const {
    for (int32_t k = 0; k < Lanes::kVectors; ++k) {
      const auto s = hn::ShiftRight<kTexelFraction>(u_.pixels(u_fx16, k));
      const auto t = hn::ShiftRight<kTexelFraction>(v_.pixels(v_fx16, k));
      hn::Store(Address::place(s, t, extent_), DStep(), place + k * Lanes::kLanesOfD);
    }
  }

  Lanes u_, v_;
  Extent extent_;
  const void* texels_;
};

// Segments that start with a group, as far as windows hold them; the rest is left.
template <class Pixel, class Address>
HWY_NOINLINE void draw_windows(const Surface& surface, Segments* segments) {
  const selvage_texture texture = surface.texture;
  const WindowSource<Pixel, Address> source(texture);
  for (int32_t k = 0; k < segments->count; ++k) {
    const int32_t rows = window_rows({segments->u.step_fx32(k), segments->v.step_fx32(k)}, texture);
    int32_t& from_px = segments->from_px[k];
    if (rows == 0 || from_px % kStepGroup_px != 0) continue;
    const StepWindows<Pixel, Address> windows(*segments, k, rows, source);
    from_px = windows.draw(from_px, segments->end_px[k], first_of<Pixel>(*segments, k, surface));
  }
}

template <class Pixel, class Address>
HWY_NOINLINE void draw_loads(const Segments& segments, const Surface& surface) {
  const selvage_texture texture = surface.texture;
  for (int32_t k = 0; k < segments.count; ++k) {
    if (segments.from_px[k] >= segments.end_px[k]) continue;
    const StepLoads<Pixel, Address> loads(segments, k, texture);
    loads.draw(segments.from_px[k], segments.end_px[k], first_of<Pixel>(segments, k, surface));
  }
}

template <class Pixel, class Address>
void draw_segments(const SteppedSpans& spans, const Surface& surface) {
  const SteppedLanes lanes(spans.field);
  SegmentWalk walk(spans);
  Segments segments;
  while (walk.next(&segments)) {
    lanes.make(&segments);
    if constexpr (kHasWindows) draw_windows<Pixel, Address>(surface, &segments);
    draw_loads<Pixel, Address>(segments, surface);
  }
}

}  // namespace

void draw_stepped(const SteppedSpans& spans, const Surface& surface) {
  with_address(surface, [&](auto address) {
    with_pixel(surface.target.format, [&](auto pixel) {
      draw_segments<decltype(pixel), decltype(address)>(spans, surface);
    });
  });
}

}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
