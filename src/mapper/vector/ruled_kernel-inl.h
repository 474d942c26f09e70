// Affine spans of which each has a map of its own. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_RULED_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_RULED_KERNEL_INL_H
#undef SELVAGE_VECTOR_RULED_KERNEL_INL_H
#else
#define SELVAGE_VECTOR_RULED_KERNEL_INL_H
#endif

#include "mapper/vector/affine_kernel-inl.h"
#include "mapper/vector/boundaries-inl.h"
#include "mapper/vector/entries-inl.h"
#include "mapper/vector/left-inl.h"
#include "mapper/vector/ruled_strips-inl.h"
#include "mapper/vector/ruled_window-inl.h"
#include "mapper/vector/tie_columns-inl.h"
#include "mapper/vector/whole_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// floor(i step) in 2^-16 texel for lane i, whole units and what the fraction adds: of any sign, as
// low as AffineBatch has them from the least lane on.
[[nodiscard]] HWY_INLINE V32 steps_fx16(int64_t step_fx32) {
  const D32 d;
  const V32 i = hn::Iota(d, 0);
  const V32 whole = hn::Mul(i, hn::Set(d, floor_fx16(step_fx32)));
  const V32 fraction = hn::Mul(i, hn::Set(d, static_cast<int32_t>(step_fx32 & 0xFFFF)));
  return hn::Add(whole, hn::ShiftRight<kAnchorShift>(fraction));
}

// The lanes of vectors of a row.
class RuledRow {
 public:
  HWY_INLINE RuledRow(const RuledRows& rows, int32_t index)
      : start_(rows.start[static_cast<size_t>(index)]),
        step_(rows.step[static_cast<size_t>(index)]),
        steps_{steps_fx16(step_.u_fx32), steps_fx16(step_.v_fx32)} {}

  // From a pixel of the span on.
  [[nodiscard]] HWY_INLINE LaneVectors lanes(int32_t offset_px) const {
    const D32 d;
    const Lane lane = plus(start_, offset_px, step_);
    return {hn::Add(hn::Set(d, floor_fx16(lane.u_fx32)), steps_.u),
            hn::Add(hn::Set(d, floor_fx16(lane.v_fx32)), steps_.v)};
  }

 private:
  Lane start_, step_;
  LaneVectors steps_;
};

template <class Pixel, class Address, class Ties>
HWY_NOINLINE void draw_decided(const RuledSpans& spans, const Surface& surface, Ties* ties) {
  const LowLanes low(lack_fx16(spans.rows.margin_fx32));
  const TexelFetch<Pixel, Address> fetch(surface.texture);
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    if (span.empty()) continue;
    const RuledRow row(spans.rows, i);
    ties->go_to(span);
    auto* const to = reinterpret_cast<Pixel*>(first_pixel(surface, span));
    for_each_vector_of(span, [&](int32_t px, int32_t count_px) HWY_ATTR {
      const TexelVectors texels = low.decided(*ties, px, row.lanes(px));
      fetch.draw(texels.s, texels.t, count_px, to + px);
    });
  }
}

[[nodiscard]] HWY_INLINE RuledBatchTies ties_of(const RuledSpans& spans) {
  return {spans.exact.ruled(), spans.rows.most_denominator,
          spare_bits_fx16(lack_fx16(spans.rows.margin_fx32))};
}

template <class Pixel, class Address>
[[nodiscard]] HWY_INLINE bool draw_between_boundaries(const RuledSpans& spans,
                                                      const Surface& surface) {
  return draw_between_boundaries<Pixel, Address>(spans.batch, TexelRanges(spans.texels),
                                                 spans.exact, spans.rows.most_denominator, surface);
}

// Draws a batch with many near-ties by columns or by boundaries. False where it is drawn by
// neither.
template <class Pixel, class Address>
[[nodiscard]] HWY_NOINLINE bool draw_near_ties(const RuledSpans& spans, const Surface& surface) {
  const LowLanes low(lack_fx16(spans.rows.margin_fx32));
  const bool has_columns =
      pays_columns_of_maps(spans.batch) &&
      is_one_limb_enough(spans.exact.ruled(), spans.rows.most_denominator, low.spare_bits());
  const bool beats = has_columns && beat_boundaries(spans.batch, TexelRanges(spans.texels));
  if (!beats && draw_between_boundaries<Pixel, Address>(spans, surface)) return true;
  if (!has_columns) return false;
  const RuledColumns lanes(spans.rows, spans.batch);
  draw_columns<Pixel, Address>(spans.batch, 0, spans.exact, surface,
                               DecidedColumnsOf<RuledColumns>(low, lanes));
  return true;
}

// Narrow rows from an index in the batch on, by a load for each pixel, but for vectors with
// near-ties. Returns the first one that is not drawn, where no more may be left.
template <class Pixel, class Address, class Fetch>
HWY_NOINLINE int32_t draw_ruled_loads(const RuledSpans& spans, const Surface& surface,
                                      int32_t first_index, Left* left) {
  constexpr int32_t kMostVectors = kMostNarrow_px / kLanes;
  static_assert(kMostVectors <= Left::kMost);
  const FixedLanes<Address> fixed(surface.texture, lack_fx16(spans.rows.margin_fx32));
  Fetch fetch(surface.texture.texels);
  int32_t i = first_index, left_count = 0;
  for (; i < spans.batch.rows && left_count <= Left::kMost - kMostVectors; ++i) {
    const Span span = spans.batch.span(i);
    const RuledRow row(spans.rows, i);
    auto* const to = reinterpret_cast<Pixel*>(first_pixel(surface, span));
    for_each_vector_of(
        span, [&](int32_t px, int32_t count_px) HWY_ATTR __attribute__((always_inline)) {
          const LaneVectors lanes = row.lanes(px);
          if (HWY_LIKELY(!fixed.any_near(lanes))) {
            return fetch.add(fixed.places(lanes), count_px, reinterpret_cast<char*>(to + px));
          }
          left->rest[static_cast<size_t>(left_count++)] = {span.row, span.left_px + px,
                                                           span.right_px};
        });
  }
  fetch.finish();
  left->count = left_count;
  return i;
}

template <class Ties>
HWY_NOINLINE void decide_left(const Left& left, const RuledSpans& spans, Ties* ties,
                              LeftTexels* texels) {
  for (int32_t k = 0; k < left.count;) {
    const int32_t row_px = left.at(k).row, index = row_px - spans.batch.first_row;
    const Span span = spans.batch.span(index);
    const AffineLanes row = spans.rows.lanes(index);
    const WholeLanes lanes(row.step(), row.margin_fx32());
    ties->go_to(span);
    for (; k < left.count && left.at(k).row == row_px; ++k) {
      const int32_t offset_px = left.at(k).left_px - span.left_px;
      WholeTexels whole = lanes.from(row.at(offset_px));
      ties->decide(offset_px, whole.near, &whole.s, &whole.t);
      texels->put(k, whole, 0);
    }
  }
}

template <class Pixel, class Address>
HWY_NOINLINE void draw_left(const Left& left, const RuledSpans& spans, const Surface& surface) {
  LeftTexels texels;
  ties_of(spans).with_ties([&](auto* ties) { decide_left(left, spans, ties, &texels); });
  draw_left<Pixel, Address>(left, texels, surface);
}

template <class Pixel, class Address>
void draw_narrow_ruled(const RuledSpans& spans, const Surface& surface) {
  using Inside = Addressed<InsideVector>;
  const bool ahead = !is_cached(surface.texture);
  const bool inside = TexelRanges(spans.texels).within(surface.texture);
  Left left;
  bool is_refused = false;
  for (int32_t i = 0; i < spans.batch.rows;) {
    const int32_t first = i;
    i = ahead    ? draw_ruled_loads<Pixel, Address, FetchAhead<Pixel>>(spans, surface, i, &left)
        : inside ? draw_ruled_loads<Pixel, Inside, FetchAtOnce<Pixel>>(spans, surface, i, &left)
                 : draw_ruled_loads<Pixel, Address, FetchAtOnce<Pixel>>(spans, surface, i, &left);
    if (left.count == 0) continue;
    if (!is_refused && are_most(left.count, i - first)) {
      if (draw_near_ties<Pixel, Address>(spans, surface)) return;
      is_refused = true;
    }
    draw_left<Pixel, Address>(left, spans, surface);
  }
}

// Rows that are taken to have many near-ties without being asked: to ask by lanes costs as much as
// an ordinary row, but to decide one in vain costs more. So none after the first row in turn that
// was asked and had them, then 1, 3 and at most 7 after each further one.
class TakenRows {
 public:
  // Whether the next row is one.
  [[nodiscard]] HWY_INLINE bool take() { return left_ > 0 && left_-- > 0; }
  // Of a row that was asked.
  HWY_INLINE void learn(bool had_many) {
    run_ = had_many ? HWY_MIN(2 * run_ + 1, kMost) : 0;
    left_ = run_ / 2;
  }

 private:
  static constexpr int32_t kMost = 15;
  int32_t run_ = 0, left_ = 0;
};

// Each row by itself, or all of them once one had many near-ties, if it is not known to be in vain.
template <class Pixel, class Address>
void draw_wide_ruled(const RuledSpans& spans, const Surface& surface, bool is_asked = false) {
  bool are_drawn = false;
  TakenRows taken;
  for_each_row(spans, [&](const AffineSpans& row) {
    if (are_drawn) return;
    if (taken.take()) return draw_row_of_ties<Pixel, Address>(row, surface);
    const bool had_many = draw_affine_as<Pixel, Address>(row, surface);
    taken.learn(had_many);
    if (!had_many || is_asked) return;
    is_asked = true;
    are_drawn = draw_between_boundaries<Pixel, Address>(spans, surface);
  });
}

// Rows with many near-ties.
template <class Pixel, class Address>
HWY_NOINLINE void draw_ruled_ties(const RuledSpans& spans, const Surface& surface) {
  if (draw_near_ties<Pixel, Address>(spans, surface)) return;
  if (!is_narrow(spans.batch)) return draw_wide_ruled<Pixel, Address>(spans, surface, true);
  ties_of(spans).with_ties([&](auto* ties) { draw_decided<Pixel, Address>(spans, surface, ties); });
}

// What window strips leave.
class RuledRest : public RestDraw {
 public:
  template <class Pixel, class Address>
  static HWY_INLINE RuledRest of(const RuledSpans& spans, const Surface& surface) {
    return {spans, surface, draw_as<Pixel, Address>};
  }

  // Draws what was kept.
  template <class Pixel, class Address>
  HWY_INLINE void finish() {
    kept_.finish([this](const Left& left) { draw_left<Pixel, Address>(left, spans_, surface_); });
  }

 private:
  HWY_INLINE RuledRest(const RuledSpans& spans, const Surface& surface, DrawAs by)
      : RestDraw(by), spans_(spans), surface_(surface) {}

  template <class Pixel, class Address>
  static HWY_NOINLINE bool draw_as(RestDraw* of, const Left& left, int32_t /*first_index*/,
                                   int32_t of_vectors) {
    auto* const rest = static_cast<RuledRest*>(of);
    if (are_many(left.count, of_vectors)) {
      draw_ruled_ties<Pixel, Address>(rest->spans_, rest->surface_);
      rest->kept_.clear();  // drawn with all others
      return false;
    }
    rest->kept_.keep(left, [rest](const Left& kept) {
      draw_left<Pixel, Address>(kept, rest->spans_, rest->surface_);
    });
    return true;
  }

  const RuledSpans& spans_;
  const Surface& surface_;
  KeptLeft kept_;
};

template <class Pixel, class Address>
HWY_NOINLINE void draw_ruled_as(const RuledSpans& spans, const Surface& surface) {
  const InOneWindow in_one = draw_one_window<Pixel, Address>(spans, surface);
  if (in_one == InOneWindow::kDrawn) return;
  if (in_one == InOneWindow::kManyNearTies) return draw_ruled_ties<Pixel, Address>(spans, surface);
  auto rest = RuledRest::of<Pixel, Address>(spans, surface);
  if (draw_window_strips<Pixel>(spans, surface, &rest)) {
    return rest.template finish<Pixel, Address>();
  }
  if (is_narrow(spans.batch)) {
    return draw_narrow_ruled<Pixel, Address>(spans, surface);
  }
  draw_wide_ruled<Pixel, Address>(spans, surface);
}

}  // namespace

void draw_ruled(const RuledSpans& spans, const Surface& surface) {
  with_address(surface, [&](auto address) {
    with_pixel(surface.target.format, [&](auto pixel) {
      draw_ruled_as<decltype(pixel), decltype(address)>(spans, surface);
    });
  });
}

}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
