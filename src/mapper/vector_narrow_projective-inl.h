// Narrow projective spans by vectors: numerators and denominators of many rows are packed one after
// another, so that divisions run in full vectors although rows are short; each row is stored under
// a mask. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_NARROW_PROJECTIVE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_NARROW_PROJECTIVE_INL_H
#undef SELVAGE_VECTOR_NARROW_PROJECTIVE_INL_H
#else
#define SELVAGE_VECTOR_NARROW_PROJECTIVE_INL_H
#endif

#include "mapper/vector_packed_ties-inl.h"
#include "mapper/vector_projective_kernel-inl.h"
#include "mapper/vector_projective_wide-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Vectors of four doubles are filled well enough by the rows themselves: packing was slower there
// by a tenth (AMD EPYC).
inline constexpr bool kPacks = kDoubles >= 8;
// So many pixels are packed at a time: what they need stays in the nearest cache.
inline constexpr int32_t kPacked_px = 512;

// Rows [first, end) of a batch.
struct PackedRows {
  int32_t first, end;
  int32_t width_px = 0;  // of all of them
};

// From `first` on, as many rows as fit.
[[nodiscard]] HWY_INLINE PackedRows rows_from(const SpanBatch& batch, int32_t first) {
  PackedRows rows{first, first};
  for (; rows.end < batch.rows; ++rows.end) {
    const int32_t width_px = batch.span(rows.end).width_px();
    if (rows.width_px + width_px > kPacked_px) break;
    rows.width_px += width_px;
  }
  return rows;
}

template <class Address>
class NarrowProjective {
  // Fewer roundings than ProjectiveField::of and what follows it.
  struct Line {
    VD start, step_x, step_y;
    HWY_INLINE Line(const ProjectiveField::Linear& line, double unit)
        : start(hn::Set(DD(), line.start * unit)),
          step_x(hn::Set(DD(), line.step_x * unit)),
          step_y(hn::Set(DD(), line.step_y * unit)) {}
    HWY_INLINE VD at(VD x, VD y) const {
      return hn::MulAdd(x, step_x, hn::MulAdd(y, step_y, start));
    }
  };

 public:
  HWY_INLINE NarrowProjective(const ProjectiveSpans& spans, const Surface& surface)
      : spans_(spans),
        surface_(surface),
        extent_(extent_of(surface.texture)),
        error_texel_(static_cast<double>(spans.field.error_fx32) * kUnit_texel) {}

  HWY_INLINE void draw(const PackedRows& rows) {
    pack(rows);
    PackedTies ties(spans_.batch, spans_.exact, rows.first);
    const ptrdiff_t bytes = bytes_per_pixel(surface_.target.format);
    HWY_ALIGN int32_t place[kLanes];
    HWY_ALIGN char texels[(kPacked_px + kMostLanes) * sizeof(uint32_t)];
    for (int32_t first = 0; first < rows.width_px; first += kLanes) {
      LowTexels texel = low_texels(parts(first), parts(first + kDoubles), error_texel_);
      if (HWY_UNLIKELY(texel.near_u || texel.near_v)) {
        ties.decide(first, texel.near_u, texel.near_v, &texel.s, &texel.t);
      }
      hn::Store(Address::place(texel.s, texel.t, extent_), D32(), place);
      fetch(surface_.texture, place, kLanes, texels + first * bytes);
    }
    with_pixel(surface_.target.format,
               [&](auto pixel) { store(rows, reinterpret_cast<const decltype(pixel)*>(texels)); });
  }

 private:
  HWY_INLINE void pack(const PackedRows& rows) {
    const DD d;
    const Line u(spans_.field.u_fx32, kUnit_texel), v(spans_.field.v_fx32, kUnit_texel);
    const Line denominator(spans_.field.denominator, 1);
    int32_t packed = 0;
    for (int32_t i = rows.first; i < rows.end; ++i) {
      const Span span = spans_.batch.span(i);
      const VD y = hn::Set(d, static_cast<double>(span.row - spans_.field.first_row));
      for (int32_t done = 0; done < span.width_px(); done += kDoubles) {
        const VD x =
            hn::Add(hn::Iota(d, 0.0),
                    hn::Set(d, static_cast<double>(span.left_px + done - spans_.field.first_px)));
        hn::StoreU(u.at(x, y), d, u_ + packed + done);
        hn::StoreU(v.at(x, y), d, v_ + packed + done);
        hn::StoreU(denominator.at(x, y), d, denominator_ + packed + done);
      }
      packed += span.width_px();
    }
    for (int32_t done = 0; done < kLanes; done += kDoubles) {  // texel (0, 0)
      hn::StoreU(hn::Zero(d), d, u_ + packed + done);
      hn::StoreU(hn::Zero(d), d, v_ + packed + done);
      hn::StoreU(hn::Set(d, 1.0), d, denominator_ + packed + done);
    }
  }

  // Of packed pixels from a number on.
  HWY_INLINE ProjectiveParts parts(int32_t first) const {
    const DD d;
    return {hn::Load(d, u_ + first), hn::Load(d, v_ + first), hn::Load(d, denominator_ + first)};
  }

  template <class Pixel>
  HWY_INLINE void store(const PackedRows& rows, const Pixel* texels) const {
    for (int32_t i = rows.first; i < rows.end; ++i) {
      const Span span = spans_.batch.span(i);
      store_row<Pixel>(texels, span.width_px(), first_pixel(surface_, span));
      texels += span.width_px();
    }
  }

  const ProjectiveSpans& spans_;
  const Surface& surface_;
  Extent extent_;
  double error_texel_;
  HWY_ALIGN double u_[kPacked_px + kMostLanes];
  HWY_ALIGN double v_[kPacked_px + kMostLanes];
  HWY_ALIGN double denominator_[kPacked_px + kMostLanes];
};

template <class Address>
void draw_narrow_projective(const ProjectiveSpans& spans, const Surface& surface) {
  NarrowProjective<Address> narrow(spans, surface);
  for (int32_t first = 0; first < spans.batch.rows;) {
    const PackedRows rows = rows_from(spans.batch, first);
    narrow.draw(rows);
    first = rows.end;
  }
}

void draw_projective(const ProjectiveSpans& spans, const Surface& surface) {
  const bool narrow = kPacks && spans.batch.rows > 1 && spans.batch.widest_px <= kNarrow_px;
  with_address(surface, [&](auto address) {
    using Address = decltype(address);
    if constexpr (kPacks) {
      if (narrow) return draw_narrow_projective<Address>(spans, surface);
    }
    with_pixel(surface.target.format,
               [&](auto pixel) { draw_wide_projective<decltype(pixel), Address>(spans, surface); });
  });
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
