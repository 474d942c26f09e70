// Spans in perspective of the filters over four texels, from windows. Included once for each SIMD
// target.
//
// Lanes are floors of estimates in double that are lowered by their error, in units of 2^-24 texel:
//
//     lane <= true value < lane + 2 error + kDividedTruncations_fx24 (spec/proofs/divided_lanes.g)
//
// By AVX-512 the product, the sum and the floor are one operation, that of adding kFloor_fx24
// rounded down: what is not rounded in between is not off either.
#if defined(SELVAGE_VECTOR_BLEND_PROJECTIVE_WINDOWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BLEND_PROJECTIVE_WINDOWS_INL_H
#undef SELVAGE_VECTOR_BLEND_PROJECTIVE_WINDOWS_INL_H
#else
#define SELVAGE_VECTOR_BLEND_PROJECTIVE_WINDOWS_INL_H
#endif

#include <bit>

#include "mapper/steepness.h"
#include "mapper/vector/blend_affine_windows-inl.h"
#include "mapper/vector/projective_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Doubles next to it are whole numbers, and their low bits those of the number added.
inline constexpr double kFloor_fx24 = 3LL << 51;
inline constexpr int64_t kFloorBits = std::bit_cast<int64_t>(kFloor_fx24);

// floor(numerator * w + less), above kFloorBits.
[[nodiscard]] HWY_INLINE VD floor_bits(VD numerator, VD w, VD less) {
#if HWY_TARGET == HWY_AVX3
  return VD{_mm512_fmadd_round_pd(numerator.raw, w.raw, less.raw,
                                  _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC)};
#else
  const VD floor = hn::Set(DD(), kFloor_fx24);
  const VD lowered = hn::MulAdd(numerator, w, hn::Sub(less, floor));
  return hn::Add(hn::Floor(lowered), floor);
#endif
}

// The low words of 64 bits each.
[[nodiscard]] HWY_INLINE V32 low_words(const double* bits) {
#if HWY_TARGET == HWY_AVX3
  HWY_ALIGN static constexpr int32_t kEven[16] = {0,  2,  4,  6,  8,  10, 12, 14,
                                                  16, 18, 20, 22, 24, 26, 28, 30};
  return V32{_mm512_permutex2var_epi32(_mm512_load_si512(bits), _mm512_load_si512(kEven),
                                       _mm512_load_si512(bits + kDoubles))};
#elif HWY_TARGET == HWY_AVX2
  // Of each vector's block after that of the other: the middle ones change places.
  const __m256 even = _mm256_shuffle_ps(
      _mm256_load_ps(reinterpret_cast<const float*>(bits)),
      _mm256_load_ps(reinterpret_cast<const float*>(bits + kDoubles)), _MM_SHUFFLE(2, 0, 2, 0));
  return V32{_mm256_permute4x64_epi64(_mm256_castps_si256(even), _MM_SHUFFLE(3, 1, 2, 0))};
#else
  static_cast<void>(bits);
  return hn::Zero(D32());
#endif
}

// Vectors of pixels, of one row or of some, whose lanes are found before the first is drawn: a
// division takes long, but the next does not wait for it.
class DividedVectorsAhead {
 public:
  static constexpr int32_t kMost = 16;

  HWY_INLINE explicit DividedVectorsAhead(const ProjectiveField& field)
      : lowered_by_fx24_(static_cast<int32_t>(field.error_fx32 >> kWindowShift) + 1) {}

  [[nodiscard]] HWY_INLINE int32_t lack_fx24() const {
    return 2 * lowered_by_fx24_ + kDividedTruncations_fx24;
  }

  // Of the vectors from `at` on, as many as fit.
  HWY_INLINE void find(const ProjectiveSpans& spans, Resume* at) {
    count_ = 0;
    int32_t i = at->row, from_px = at->px;
    for (; i < spans.batch.rows; ++i) {
      const Span span = spans.batch.span(i);
      const int32_t px = HWY_MAX(span.left_px, from_px);
      from_px = INT32_MIN;
      if (px >= span.right_px) continue;
      const int32_t vectors = HWY_MIN((span.right_px - px + kLanes - 1) / kLanes, kMost - count_);
      if (vectors == 0) {
        from_px = px;
        break;
      }
      find(spans.field.of(span), px - span.left_px, vectors);
      for (int32_t k = 0; k < vectors; ++k, ++count_) {
        row_[count_] = span.row;
        left_px_[count_] = px + k * kLanes;
        right_px_[count_] = span.right_px;
      }
      from_px = px + vectors * kLanes;
      if (from_px < span.right_px) break;
      from_px = INT32_MIN;
    }
    *at = {i, from_px};
  }

  [[nodiscard]] HWY_INLINE int32_t count() const { return count_; }
  // The rest of its span, from the k-th vector on.
  [[nodiscard]] HWY_INLINE int32_t row(int32_t k) const { return row_[k]; }
  [[nodiscard]] HWY_INLINE int32_t left_px(int32_t k) const { return left_px_[k]; }
  [[nodiscard]] HWY_INLINE int32_t right_px(int32_t k) const { return right_px_[k]; }
  HWY_INLINE Anchor_fx24 lane(int32_t k, int32_t i) const {
    return {lane_fx24(u_[k][i]), lane_fx24(v_[k][i])};
  }
  HWY_INLINE WindowLanes lanes(int32_t k, int32_t u_shift_fx24, int32_t v_shift_fx24) const {
    return {shifted(u_[k], u_shift_fx24), shifted(v_[k], v_shift_fx24)};
  }

 private:
  using Linear = DividedLanes::Linear;
  static constexpr double kUnit_fx24 = 1.0 / (1 << kWindowShift);
  static constexpr int32_t kHalf_fx24 = 1 << (kWindowFraction - 1);

  static HWY_INLINE VD at(const Linear& line, VD i) {
    const DD d;
    return hn::MulAdd(i, hn::Set(d, line.step), hn::Set(d, line.start));
  }
  static HWY_INLINE Linear fx24(const Linear& fx32) {
    return {fx32.start * kUnit_fx24, fx32.step * kUnit_fx24};
  }
  static HWY_INLINE int64_t lane_fx24(double bits) {
    return std::bit_cast<int64_t>(bits) - kFloorBits - kHalf_fx24;
  }
  static HWY_INLINE V32 shifted(const double* bits, int32_t shift_fx24) {
    const uint32_t shift = static_cast<uint32_t>(shift_fx24) - uint32_t{kHalf_fx24};
    return hn::Add(low_words(bits), hn::Set(D32(), static_cast<int32_t>(shift)));
  }

  HWY_INLINE void find(const DividedLanes& along, int32_t offset_px, int32_t vectors) {
    const DD d;
    const Linear u = fx24(along.u_numerator_fx32()), v = fx24(along.v_numerator_fx32());
    const VD less = hn::Set(d, kFloor_fx24 - lowered_by_fx24_);
    VD i = hn::Add(hn::Iota(d, 0.0), hn::Set(d, static_cast<double>(offset_px)));
    for (int32_t k = count_; k < count_ + vectors; ++k) {
      for (int32_t lane = 0; lane < kLanes; lane += kDoubles) {
        const VD w = hn::Div(hn::Set(d, 1.0), at(along.denominator(), i));
        hn::Store(floor_bits(at(u, i), w, less), d, u_[k] + lane);
        hn::Store(floor_bits(at(v, i), w, less), d, v_[k] + lane);
        i = hn::Add(i, hn::Set(d, static_cast<double>(kDoubles)));
      }
    }
  }

  int32_t lowered_by_fx24_;
  int32_t count_ = 0;
  int32_t row_[kMost], left_px_[kMost], right_px_[kMost];
  HWY_ALIGN double u_[kMost][kLanes], v_[kMost][kLanes];
};

// As with affine spans.
template <class Window, bool kFour>
HWY_NOINLINE void blend_windows(const ProjectiveSpans& spans, const Surface& surface, Resume* at,
                                Left* left) {
  char* const pixels = static_cast<char*>(surface.target.pixels);
  const ptrdiff_t pitch = surface.target.pitch;
  const int64_t end_u_fx24 = (surface.texture.width - 1) * kOneTexel_fx24;
  const int64_t end_v_fx24 = (surface.texture.height - 1) * kOneTexel_fx24;
  DividedVectorsAhead vectors(spans.field);
  const WindowBlender<Window, kFour> blender(surface, vectors.lack_fx24());
  int32_t left_count = 0;
  while (at->row < spans.batch.rows && left_count <= Left::kMost - DividedVectorsAhead::kMost) {
    vectors.find(spans, at);
    for (int32_t k = 0; k < vectors.count(); ++k) {
      const int32_t row = vectors.row(k), px = vectors.left_px(k);
      const int32_t count_px = vectors.right_px(k) - px;
      // Along a span u and v rise or fall all the way: its ends have the least and the most.
      const Anchor_fx24 first = vectors.lane(k, 0);
      const Anchor_fx24 last = vectors.lane(k, HWY_MIN(count_px, kLanes) - 1);
      const Anchor_fx24 least{HWY_MIN(first.u, last.u), HWY_MIN(first.v, last.v)};
      const bool inside = least.u >= 0 && least.v >= 0 && HWY_MAX(first.u, last.u) < end_u_fx24 &&
                          HWY_MAX(first.v, last.v) < end_v_fx24;
      const bool drawn =
          blender.draw([&](int32_t u_shift_fx24, int32_t v_shift_fx24)
                           HWY_ATTR { return vectors.lanes(k, u_shift_fx24, v_shift_fx24); },
                       least, static_cast<int32_t>(HWY_MAX(first.v, last.v) - least.v), inside,
                       count_px, reinterpret_cast<uint32_t*>(pixels + row * pitch) + px);
      if (HWY_LIKELY(drawn)) continue;
      left->rest[static_cast<size_t>(left_count++)] = {row, px, vectors.right_px(k)};
    }
  }
  left->count = left_count;
}

// How far apart neighbouring pixels are at most. Too far for a window counts as infinite.
[[nodiscard]] HWY_INLINE Lane steepest_fx32(const ProjectiveSpans& spans) {
  constexpr double kTooSteep = 0x1p33;
  double u = 0, v = 0;
  for (int32_t i = 0; i < spans.batch.rows; ++i) {
    const Span span = spans.batch.span(i);
    if (span.empty()) continue;
    const DividedLanes lanes = spans.field.of(span);
    u = HWY_MAX(u, steepest_fx32(lanes.u_numerator_fx32(), lanes.denominator(), span.width_px()));
    v = HWY_MAX(v, steepest_fx32(lanes.v_numerator_fx32(), lanes.denominator(), span.width_px()));
  }
  return {static_cast<int64_t>(HWY_MIN(u, kTooSteep)) + 1,
          static_cast<int64_t>(HWY_MIN(v, kTooSteep)) + 1};
}

template <bool kFour>
[[nodiscard]] HWY_INLINE BlendWindows<ProjectiveSpans> blend_windows_for(
    const ProjectiveSpans& spans, const Surface& surface) {
  if (!kHasBlendWindows || spans.field.error_fx32 >> kWindowShift > kMostLack_fx24 / 2) {
    return nullptr;
  }
  BlendWindows<ProjectiveSpans> found = nullptr;
  with_blend_window(steepest_fx32(spans), spans.texels, surface, [&](auto window) {
    using Window = typename decltype(window)::type;
    found = blend_windows<Window, kFour>;
  });
  return found;
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
