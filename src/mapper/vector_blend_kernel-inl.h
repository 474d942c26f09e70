// The filters over four texels by vectors: points on a grid of 1/256 texel, the texels around them,
// and their mean with weights on that grid. Included once for each SIMD target.
//
// Four and bilinear are one formula: (a + b + c + d + 2) >> 2 is the bilinear sum with all weights
// 1/2, for (2^14 S + 2^15) >> 16 = (S + 2) >> 2.
#if defined(SELVAGE_VECTOR_BLEND_KERNEL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BLEND_KERNEL_INL_H
#undef SELVAGE_VECTOR_BLEND_KERNEL_INL_H
#else
#define SELVAGE_VECTOR_BLEND_KERNEL_INL_H
#endif

#include <bit>

#include "mapper/filter_point.h"
#include "mapper/vector_kernel-inl.h"
#include "mapper/vector_projective_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// ---- Points: floor(256 (u - 1/2)) and floor(256 (v - 1/2)) of kLanes pixels
// ----------------------

struct PointVectors {
  V32 u_fx8, v_fx8;
};

// The exact row in units of the grid, so that its texels are points.
[[nodiscard]] inline ExactRow on_grid(const ExactRow& row) {
  const auto finer = [](uint128 a) {
    return static_cast<uint128>(static_cast<int128>(a) >> kGridBits);  // a multiple of 2^16
  };
  return {row.u, row.v, {finer(row.d.start), finer(row.d.step)}};
}

[[nodiscard]] HWY_INLINE PointVectors from_centres(V32 u_fx8, V32 v_fx8) {
  const V32 half = hn::Set(D32(), kTexel_fx8 / 2);
  return {hn::Sub(u_fx8, half), hn::Sub(v_fx8, half)};
}

// 32.32 lanes, in two vectors of 64 bits.
using D64 = hn::Repartition<int64_t, D32>;
using V64 = hn::Vec<D64>;

class AffinePoints {
 public:
  HWY_INLINE explicit AffinePoints(const AffineSpans& spans) : spans_(spans) {
    HWY_ALIGN int64_t u[kLanes], v[kLanes];
    for (int32_t i = 0; i < kLanes; ++i) {
      u[i] = i * spans.field.step_x.u_fx32;
      v[i] = i * spans.field.step_x.v_fx32;
    }
    const D64 d;
    u_low_ = hn::Load(d, u);
    u_high_ = hn::Load(d, u + kLanes / 2);
    v_low_ = hn::Load(d, v);
    v_high_ = hn::Load(d, v + kLanes / 2);
  }

  HWY_INLINE PointVectors at(const Span& span, int32_t px) const {
    const Lane lane = spans_.field.at(px, span.row);
    V32 near_u, near_v;
    const V32 u = floors(lane.u_fx32, u_low_, u_high_, &near_u);
    const V32 v = floors(lane.v_fx32, v_low_, v_high_, &near_v);
    if (HWY_LIKELY(hn::AllFalse(D32(), is_set(hn::Or(near_u, near_v))))) return from_centres(u, v);
    const uint32_t asked = first_bits(HWY_MIN(span.right_px - px, kLanes));
    return decided(span, px, {u, v}, lane_bits(D32(), is_set(near_u)) & asked,
                   lane_bits(D32(), is_set(near_v)) & asked);
  }

 private:
  static HWY_INLINE hn::Mask<D32> is_set(V32 value) { return hn::Ne(value, hn::Zero(D32())); }

  // Floors on the grid; bits of `near` are set where a lane may lack enough to reach the next.
  HWY_INLINE V32 floors(int64_t start_fx32, V64 low_steps, V64 high_steps, V32* near) const {
    const D64 d;
    const D32 d32;
    const V64 low = hn::Add(hn::Set(d, start_fx32), low_steps);
    const V64 high = hn::Add(hn::Set(d, start_fx32), high_steps);
    const auto narrow = [&](V64 upper, V64 lower) {
      return hn::ConcatEven(d32, hn::BitCast(d32, upper), hn::BitCast(d32, lower));
    };
    const V32 fraction = hn::And(narrow(high, low), hn::Set(d32, (1 << kGridFraction) - 1));
    const V32 margin = hn::Set(d32, static_cast<int32_t>(spans_.field.margin_fx32));
    *near = hn::ShiftRight<kGridFraction>(hn::Add(fraction, margin));
    return narrow(hn::ShiftRight<kGridFraction>(high), hn::ShiftRight<kGridFraction>(low));
  }

  HWY_NOINLINE PointVectors decided(const Span& span, int32_t px, PointVectors low, uint32_t near_u,
                                    uint32_t near_v) const {
    const ExactRow row = on_grid(spans_.exact.row_from(px, span.row));
    return from_centres(decide(D32(), low.u_fx8, near_u, row, row.u),
                        decide(D32(), low.v_fx8, near_v, row, row.v));
  }

  const AffineSpans& spans_;
  V64 u_low_, u_high_, v_low_, v_high_;
};

static_assert(kWidestMargin_fx32 < int64_t{1} << 31);

class ProjectivePoints {
 public:
  HWY_INLINE ProjectivePoints(const ProjectiveSpan& each, const ExactMap& map)
      : each_(each), map_(map), row_(each.lanes, kTexel_fx8) {}

  HWY_INLINE PointVectors at(const Span& /*span*/, int32_t px) const {
    HWY_ALIGN int32_t u[kLanes], v[kLanes];
    for (int32_t done = 0; done < kLanes; done += kDoubles) find(px + done, u + done, v + done);
    return from_centres(hn::Load(D32(), u), hn::Load(D32(), v));
  }

 private:
  HWY_INLINE void find(int32_t px, int32_t* HWY_RESTRICT u, int32_t* HWY_RESTRICT v) const {
    const DHalf d;
    uint32_t near_u, near_v;
    LowTexels low = row_.low(px - each_.span.left_px, &near_u, &near_v);
    const uint32_t asked = first_bits(HWY_MIN(HWY_MAX(each_.span.right_px - px, 0), kDoubles));
    near_u &= asked;
    near_v &= asked;
    if (HWY_UNLIKELY((near_u | near_v) != 0)) {
      const ExactRow exact = on_grid(map_.row_from(px, each_.span.row));
      low.s = decide(d, low.s, near_u, exact, exact.u);
      low.t = decide(d, low.t, near_v, exact, exact.v);
    }
    hn::StoreU(low.s, d, u);
    hn::StoreU(low.t, d, v);
  }

  const ProjectiveSpan& each_;
  const ExactMap& map_;
  ProjectiveRow row_;
};

// ---- The texels around kLanes points ------------------------------------------------------------

// Two texels side by side are eight bytes.
struct Neighbours {
  HWY_ALIGN uint64_t upper[kLanes];
  HWY_ALIGN uint64_t lower[kLanes];
};

[[nodiscard]] HWY_INLINE uint64_t load_pair(const char* at) {
  uint64_t pair;
  std::memcpy(&pair, at, sizeof pair);
  return pair;
}

// Whatever a lane means, its places are valid.
template <class Address>
HWY_INLINE void fetch_around(const PointVectors& points, const selvage_texture& texture,
                             Neighbours* around) {
  const D32 d;
  const V32 one = hn::Set(d, 1);
  const Extent extent = extent_of(texture);
  const V32 s = hn::ShiftRight<kGridBits>(points.u_fx8);
  const V32 t = hn::ShiftRight<kGridBits>(points.v_fx8);
  const V32 left = Address::column(s, extent);
  const V32 right = Address::column(hn::Add(s, one), extent);
  const V32 upper = Address::row(t, extent);
  const V32 lower = Address::row(hn::Add(t, one), extent);
  const auto* texels = static_cast<const char*>(texture.texels);
  constexpr ptrdiff_t kBytes = sizeof(uint32_t);
  HWY_ALIGN int32_t upper_left[kLanes], lower_left[kLanes];
  hn::Store(hn::Add(upper, left), d, upper_left);
  hn::Store(hn::Add(lower, left), d, lower_left);
  if (HWY_LIKELY(hn::AllTrue(d, hn::Eq(hn::Sub(right, left), one)))) {
    for (int32_t i = 0; i < kLanes; ++i) {
      around->upper[i] = load_pair(texels + upper_left[i] * kBytes);
      around->lower[i] = load_pair(texels + lower_left[i] * kBytes);
    }
    return;
  }
  HWY_ALIGN int32_t upper_right[kLanes], lower_right[kLanes];
  hn::Store(hn::Add(upper, right), d, upper_right);
  hn::Store(hn::Add(lower, right), d, lower_right);
  const auto pair = [&](int32_t left_place, int32_t right_place) {
    uint32_t first, second;
    std::memcpy(&first, texels + left_place * kBytes, sizeof first);
    std::memcpy(&second, texels + right_place * kBytes, sizeof second);
    static_assert(std::endian::native == std::endian::little);
    return uint64_t{second} << 32 | first;
  };
  for (int32_t i = 0; i < kLanes; ++i) {
    around->upper[i] = pair(upper_left[i], upper_right[i]);
    around->lower[i] = pair(lower_left[i], lower_right[i]);
  }
}

// ---- Mixing -------------------------------------------------------------------------------------

// A pixel is a block of 128 bits: four channels of 32 bits.
inline constexpr int32_t kPixelsPerVector = kLanes / 4;

// In each block the weights of one pixel, (256 - w) | w << 16, for the pixels first ...
[[nodiscard]] HWY_INLINE V32 spread(V32 weights, int32_t first) {
  const D32 d;
  const V32 block = hn::ShiftRight<2>(hn::Iota(d, 0));
  return hn::TableLookupLanes(weights, hn::IndicesFromVec(d, hn::Add(block, hn::Set(d, first))));
}

// Sums of products of 16-bit neighbours. Which products Highway's widening sum adds is left to the
// target: x86 has an instruction that adds neighbours.
[[nodiscard]] HWY_INLINE V32 pair_products(V32 a, V32 b) {
#if HWY_ARCH_X86
  const D32 d;
  const hn::Repartition<int16_t, D32> d16;
  V32 unused = hn::Zero(d);
  return hn::ReorderWidenMulAccumulate(d, hn::BitCast(d16, a), hn::BitCast(d16, b), hn::Zero(d),
                                       unused);
#else
  const auto low = [](V32 v) { return hn::ShiftRight<16>(hn::ShiftLeft<16>(v)); };
  const auto high = [](V32 v) { return hn::ShiftRight<16>(v); };
  return hn::Add(hn::Mul(low(a), low(b)), hn::Mul(high(a), high(b)));
#endif
}

// left (256 - w) + right w for each channel, of pairs of texels.
[[nodiscard]] HWY_INLINE V32 mix_pairs(const uint64_t* pairs, V32 weights) {
  const hn::Repartition<uint16_t, D32> d16;
  const hn::Rebind<uint8_t, decltype(d16)> d8;
  const auto bytes = hn::PromoteTo(d16, hn::LoadU(d8, reinterpret_cast<const uint8_t*>(pairs)));
  // Channels of the left texel beside those of the right one.
  HWY_ALIGN static constexpr uint8_t kInterleave[16] = {0, 1, 8,  9,  2, 3, 10, 11,
                                                        4, 5, 12, 13, 6, 7, 14, 15};
  const hn::Repartition<uint8_t, D32> d_bytes;
  const auto order = hn::LoadDup128(d_bytes, kInterleave);
  const auto together = hn::TableLookupBytes(hn::BitCast(d_bytes, bytes), order);
  return pair_products(hn::BitCast(D32(), together), weights);
}

// Both sums of a column are below 2^16, so they fit a pair if they are less 2^15.
[[nodiscard]] HWY_INLINE V32 mix_rows(V32 upper, V32 lower, V32 weights) {
  const D32 d;
  constexpr int32_t kRounding = 1 << (2 * kGridBits - 1);
  const V32 both = hn::Xor(hn::Or(upper, hn::ShiftLeft<16>(lower)),
                           hn::Set(d, static_cast<int32_t>(0x80008000)));
  const V32 sum = hn::Add(pair_products(both, weights), hn::Set(d, (kTexel_fx8 << 15) + kRounding));
  return hn::ShiftRight<2 * kGridBits>(sum);
}

[[nodiscard]] HWY_INLINE V32 weight_pairs(V32 point_fx8, bool four) {
  const D32 d;
  const V32 second =
      four ? hn::Set(d, kTexel_fx8 / 2) : hn::And(point_fx8, hn::Set(d, kTexel_fx8 - 1));
  return hn::Or(hn::ShiftLeft<16>(second), hn::Sub(hn::Set(d, kTexel_fx8), second));
}

HWY_INLINE void mix(const PointVectors& points, const Neighbours& around, bool four,
                    uint8_t* HWY_RESTRICT pixels) {
  const hn::Rebind<uint8_t, D32> d8;
  const V32 across = weight_pairs(points.u_fx8, four), down = weight_pairs(points.v_fx8, four);
  for (int32_t first = 0; first < kLanes; first += kPixelsPerVector) {
    const V32 weights = spread(across, first);
    const V32 mean = mix_rows(mix_pairs(around.upper + first, weights),
                              mix_pairs(around.lower + first, weights), spread(down, first));
    hn::StoreU(hn::DemoteTo(d8, mean), d8, pixels + first * ptrdiff_t{sizeof(uint32_t)});
  }
}

// ---- Spans --------------------------------------------------------------------------------------

template <class Address, class Points>
HWY_INLINE void draw_blended(const Points& points, const Span& span, const Surface& surface,
                             bool four) {
  Neighbours around;
  HWY_ALIGN uint8_t tail[kLanes * sizeof(uint32_t)];
  char* pixel = first_pixel(surface, span);
  for (int32_t px = span.left_px; px < span.right_px; px += kLanes) {
    const PointVectors at = points.at(span, px);
    fetch_around<Address>(at, surface.texture, &around);
    if (HWY_LIKELY(span.right_px - px >= kLanes)) {
      mix(at, around, four, reinterpret_cast<uint8_t*>(pixel));
      pixel += sizeof tail;
    } else {
      mix(at, around, four, tail);
      std::memcpy(pixel, tail, static_cast<size_t>(span.right_px - px) * sizeof(uint32_t));
    }
  }
}

// One body for both filters: it is large, and there is one for each address mode.
HWY_NOINLINE void blend_affine(const AffineSpans& spans, const Surface& surface, bool four) {
  with_address(surface, [&](auto address) {
    const AffinePoints points(spans);
    for (int32_t i = 0; i < spans.batch.rows; ++i) {
      draw_blended<decltype(address)>(points, spans.batch.span(i), surface, four);
    }
  });
}
template <bool kFour>
void draw_blended_affine(const AffineSpans& spans, const Surface& surface) {
  blend_affine(spans, surface, kFour);
}

// Where lanes may lack more than a step of the grid, one decision is not enough.
[[nodiscard]] inline bool are_fine(const ProjectiveLanes& lanes) {
  return lanes.margin_fx32() < uint32_t{1} << kGridFraction;
}

HWY_NOINLINE void blend_projective(const ProjectiveSpans& spans, const Surface& surface,
                                   bool four) {
  const auto& scalar = scalar_kernels(four ? SELVAGE_FILTER_FOUR : SELVAGE_FILTER_BILINEAR);
  with_address(surface, [&](auto address) {
    for (const ProjectiveSpan& each : spans.spans) {
      if (are_fine(each.lanes)) {
        const ProjectivePoints points(each, spans.exact);
        draw_blended<decltype(address)>(points, each.span, surface, four);
      } else {
        scalar.draw_projective({{&each, 1}, spans.exact}, surface);
      }
    }
  });
}

template <bool kFour>
void draw_blended_projective(const ProjectiveSpans& spans, const Surface& surface) {
  blend_projective(spans, surface, kFour);
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
