// Affine spans near a plane, of which each has a map of its own. Included once for each SIMD
// target.
#if defined(SELVAGE_VECTOR_NEAR_PLANE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_NEAR_PLANE_INL_H
#undef SELVAGE_VECTOR_NEAR_PLANE_INL_H
#else
#define SELVAGE_VECTOR_NEAR_PLANE_INL_H
#endif

#include <span>

#include "mapper/near_plane.h"
#include "mapper/vector/affine_kernel-inl.h"
#include "mapper/vector/ruled_kernel-inl.h"
#include "mapper/vector/tie_columns-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

inline constexpr int kLeastNearSpareBits = 6;
static_assert(kVectorTruncations_fx16 + (kMostNearMargin_fx32 >> kAnchorShift) + 1 <
              1 << (kTexelFraction - kLeastNearSpareBits));
// So that lanes_fit() leaves room for them.
static_assert(kMostNearMargin_fx32 >> kAnchorShift < 1 << kTexelFraction);

using PlaneLanes = AffineBatch<Addressed<InsideVector>>;

// Parts of rows that have no more than Left::kMost vectors together. They are decided first and
// drawn then: to wait for one row's texels would be to wait for all that decides them.
class RowParts {
 public:
  static constexpr int32_t kMost_px = Left::kMost * kLanes;  // of one

  [[nodiscard]] HWY_INLINE std::span<const Span> all() const { return {parts_, count_}; }
  [[nodiscard]] HWY_INLINE bool has_room_for(const Span& part) const {
    return vectors_ + vectors_of(part) <= Left::kMost;
  }
  HWY_INLINE void add(const Span& part) {
    parts_[count_++] = part;
    vectors_ += vectors_of(part);
  }
  HWY_INLINE void clear() {
    count_ = 0;
    vectors_ = 0;
  }

 private:
  static HWY_INLINE int32_t vectors_of(const Span& part) {
    return (part.width_px() + kLanes - 1) / kLanes;
  }

  size_t count_ = 0;
  int32_t vectors_ = 0;
  Span parts_[Left::kMost];
};

template <class Ties>
HWY_NOINLINE void decide_parts(const RowParts& parts, const AffineField& field,
                               const PlaneLanes& lanes, Ties* ties, DecidedTexels* texels) {
  int32_t k = 0;
  for (const Span& part : parts.all()) {
    ties->go_to(part);
    const Lane first = lanes.anchor(field.at(part.left_px, part.row));
    for_each_vector_of(part, [&](int32_t px, int32_t /*count_px*/) HWY_ATTR {
      const Lane anchor = plus(first, px, field.step_x);
      texels->put(k++, lanes.decided(*ties, px, lanes.lanes_from(anchor)));
    });
  }
}

template <class Pixel, class Address>
HWY_NOINLINE void draw_parts(const RowParts& parts, const DecidedTexels& texels,
                             const Surface& surface) {
  const TexelFetch<Pixel, Address> fetch(surface.texture);
  char* const pixels = static_cast<char*>(surface.target.pixels);
  const ptrdiff_t pitch = surface.target.pitch;
  int32_t k = 0;
  for (const Span& part : parts.all()) {
    auto* const to = reinterpret_cast<Pixel*>(pixels + part.row * pitch) + part.left_px;
    for_each_vector_of(part, [&](int32_t px, int32_t count_px) HWY_ATTR {
      const TexelVectors at = texels.at(k++);
      fetch.draw(at.s, at.t, count_px, to + px);
    });
  }
}

static_assert(kDenominatorBits - kLeastNearSpareBits < TwoLimbs::kBits - 1, "|n - k d|, its sign");

// Decides what is left by the rows' own maps, which are those of a RuledMap: where it is few of
// each strip, when all is known of the batch.
class NearPlaneRest : public RestDraw {
 public:
  template <class Pixel, class Address>
  static HWY_INLINE NearPlaneRest of(const AffineSpans& spans, const Surface& surface) {
    return {spans, surface, draw_as<Pixel, Address>};
  }

  // Draws those that were few. Most are in no doubt by the lanes of their own rows.
  template <class Pixel, class Address>
  HWY_INLINE void finish() {
    few_.finish([this](const Left& few) { draw_few<Pixel, Address>(few); });
  }

 private:
  HWY_INLINE NearPlaneRest(const AffineSpans& spans, const Surface& surface, DrawAs by)
      : RestDraw(by), spans_(spans), surface_(surface) {}

  template <class Pixel, class Address>
  static HWY_NOINLINE bool draw_as(RestDraw* of, const Left& left, int32_t first_index,
                                   int32_t of_vectors) {
    auto* const rest = static_cast<NearPlaneRest*>(of);
    if (are_many(left.count, of_vectors)) {
      rest->draw_all<Pixel, Address>(first_index);
      return false;
    }
    rest->few_.keep(left, [rest](const Left& few) { rest->draw_few<Pixel, Address>(few); });
    return true;
  }

  template <class Pixel, class Address>
  HWY_NOINLINE void draw_few(const Left& few) const {
    RuledRows rows;
    const std::span of(few.rest.data(), static_cast<size_t>(few.count));
    find_lanes_of(spans_.exact.ruled(), spans_.batch, of, &rows);
    draw_left<Pixel, Address>(few, RuledSpans{spans_.batch, rows, spans_.texels, spans_.exact},
                              surface_);
  }

  // The rows from an index in the batch on.
  template <class Pixel, class Address>
  HWY_NOINLINE void draw_all(int32_t first_index) const {
    const PlaneLanes lanes(spans_, surface_);
    const RuledMap& map = spans_.exact.ruled();
    if (pays_columns_of_maps(spans_.batch) &&
        is_one_limb_enough(map, map.most_denominator(), lanes.spare_bits())) {
      return draw_columns<Pixel, Address>(
          spans_.batch, first_index, spans_.exact, surface_,
          DecidedColumnsOf<PlaneColumns>(lanes, PlaneColumns(spans_.field)));
    }
    RuledBatchTies batch_ties(map, map.most_denominator(), lanes.spare_bits(),
                              RuledBatchTies::Asked::kOften);
    RowParts parts;
    DecidedTexels texels;
    const auto draw = [&] {
      batch_ties.with_ties(
          [&](auto* ties) { decide_parts(parts, spans_.field, lanes, ties, &texels); });
      draw_parts<Pixel, Address>(parts, texels, surface_);
      parts.clear();
    };
    for (int32_t i = first_index; i < spans_.batch.rows; ++i) {
      const Span span = spans_.batch.span(i);
      for (int32_t px = span.left_px; px < span.right_px; px += RowParts::kMost_px) {
        const Span part{span.row, px, HWY_MIN(px + RowParts::kMost_px, span.right_px)};
        if (!parts.has_room_for(part)) draw();
        parts.add(part);
      }
    }
    draw();
  }

  const AffineSpans& spans_;
  const Surface& surface_;
  KeptLeft few_;
};

template <class Pixel, class Address>
HWY_NOINLINE void draw_near_plane_as(const AffineSpans& spans, const Surface& surface) {
  auto rest = NearPlaneRest::of<Pixel, Address>(spans, surface);
  draw_by_vectors<Pixel, Address>(spans, surface, {kWindowColumnBits, 0}, &rest);
  rest.template finish<Pixel, Address>();
}

}  // namespace

// From windows, vectors are drawn so fast that what decides near-ties would cost more than six
// times as much.
bool pays_near_plane(const AffineField& field, const Surface& surface) {
  return window_rows(field.step_x, surface.texture) == 0;
}

void draw_near_plane(const AffineSpans& spans, const Surface& surface) {
  with_address(surface, [&](auto address) {
    with_pixel(surface.target.format, [&](auto pixel) {
      draw_near_plane_as<decltype(pixel), decltype(address)>(spans, surface);
    });
  });
}

}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
