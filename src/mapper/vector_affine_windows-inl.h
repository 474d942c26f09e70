// Affine spans by windows, those of some vectors of a row found at once. Included once for each
// SIMD target.
#if defined(SELVAGE_VECTOR_AFFINE_WINDOWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_AFFINE_WINDOWS_INL_H
#undef SELVAGE_VECTOR_AFFINE_WINDOWS_INL_H
#else
#define SELVAGE_VECTOR_AFFINE_WINDOWS_INL_H
#endif

#include "mapper/vector_affine_lanes-inl.h"
#include "mapper/vector_coarse_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Where a hot loop goes on: in this row of the batch, not before this pixel.
struct Resume {
  int32_t row = 0, px = INT32_MIN;
};

// Vectors of pixels side by side: the lanes of their anchors, counted from the origins of their
// windows, and the places of those, negative where there is none. So many, for a run is read so
// soon after it is written that its first vectors wait for it.
inline constexpr int32_t kRunVectors = 2 * kMostLanes, kRun_px = kRunVectors * kLanes;
struct WindowRun {
  HWY_ALIGN int32_t u_fx16[kRunVectors], v_fx16[kRunVectors];
  HWY_ALIGN int32_t coarse[kRunVectors];  // both, as CoarseLanes has them
  HWY_ALIGN int32_t place[kRunVectors];
};

// Of one coordinate: the lanes of a run's anchors, kLanes of them from the k-th on.
class AnchorRun {
 public:
  HWY_INLINE explicit AnchorRun(int64_t step_fx32) {
    for (int64_t i = 0; i < kRunVectors; ++i) offsets_fx32_[i] = i * kLanes * step_fx32;
  }
  HWY_INLINE V32 texels(int64_t first_fx32, int32_t k) const {
    return hn::ConcatOdd(D32(), half(first_fx32, k + kLanes / 2), half(first_fx32, k));
  }
  HWY_INLINE V32 fractions_fx16(int64_t first_fx32, int32_t k) const {
    const hn::RebindToUnsigned<D32> du;
    const V32 low = hn::ConcatEven(D32(), half(first_fx32, k + kLanes / 2), half(first_fx32, k));
    return hn::BitCast(D32(), hn::ShiftRight<kAnchorShift>(hn::BitCast(du, low)));
  }

 private:
  HWY_INLINE V32 half(int64_t first_fx32, int32_t k) const {
    const hn::Repartition<int64_t, D32> d;
    return hn::BitCast(D32(), hn::Add(hn::Set(d, first_fx32), hn::Load(d, offsets_fx32_ + k)));
  }

  HWY_ALIGN int64_t offsets_fx32_[kRunVectors];
};

// How a texture is addressed, told at run time: windows are found so seldom that one loop is for
// all modes.
enum class Addressing { kClamped, kMasked, kWrapped };

[[nodiscard]] HWY_INLINE Addressing addressing_of(const Surface& surface) {
  if (surface.address == SELVAGE_ADDRESS_CLAMP) return Addressing::kClamped;
  const bool masked =
      WrapMasked::fits(surface.texture.width) && WrapMasked::fits(surface.texture.height);
  return masked ? Addressing::kMasked : Addressing::kWrapped;
}

// Finds the windows of a run by its first anchor.
template <class Coarse>
class WindowFinder {
 public:
  HWY_INLINE WindowFinder(const AffineField& field, const Surface& surface,
                          const WindowShape& shape, bool inside)
      : u_(field.step_x.u_fx32),
        v_(field.step_x.v_fx32),
        extent_(extent_of(surface.texture)),
        shape_(shape),
        addressing_(inside ? Addressing::kClamped : addressing_of(surface)) {}

  // The first windows of a run, at least so many.
  HWY_INLINE void find(Lane anchor, int32_t vectors, WindowRun* run) const {
    const D32 d;
    const auto from = [&](V32 texel, V32 origin, V32 fraction_fx16) HWY_ATTR {
      return hn::Or(hn::ShiftLeft<kTexelFraction>(hn::Sub(texel, origin)), fraction_fx16);
    };
    for (int32_t k = 0; k < kRunVectors && k < vectors; k += kLanes) {
      const V32 s = u_.texels(anchor.u_fx32, k), t = v_.texels(anchor.v_fx32, k);
      const WindowOrigins<V32> origins = origins_of(s, t);
      const V32 u = from(s, origins.s, u_.fractions_fx16(anchor.u_fx32, k));
      const V32 v = from(t, origins.t, v_.fractions_fx16(anchor.v_fx32, k));
      hn::Store(u, d, run->u_fx16 + k);
      hn::Store(v, d, run->v_fx16 + k);
      hn::Store(Coarse::pack({u, v}), d, run->coarse + k);
      hn::Store(origins.place, d, run->place + k);
    }
  }

 private:
  HWY_INLINE WindowOrigins<V32> origins_of(V32 s, V32 t) const {
    const V32 columns = hn::Set(D32(), 1 << shape_.column_bits), rows = hn::Set(D32(), shape_.rows);
    switch (addressing_) {
      case Addressing::kMasked:
        return window_origins<WrapMaskedVector>(s, t, columns, rows, extent_);
      case Addressing::kWrapped:
        return window_origins<WrapVector>(s, t, columns, rows, extent_);
      default:
        return window_origins<ClampVector>(s, t, columns, rows, extent_);
    }
  }

  AnchorRun u_, v_;
  Extent extent_;
  WindowShape shape_;
  Addressing addressing_;
};

// Draws vectors by windows of one shape; kRows is 0 for any number of rows.
template <class Pixel, class InWindow, int kColumnBits, int32_t kRows>
class WindowDraw {
 public:
  using Coarse = CoarseLanes<kColumnBits, kRows == 0 ? kMostWindowRows : kRows>;

  HWY_INLINE WindowDraw(const AffineSpans& spans, const Surface& surface, int32_t rows)
      : batch_(spans, surface),
        coarse_(batch_.offsets(), batch_.lack_fx16()),
        texels_(static_cast<const Pixel*>(surface.texture.texels)),
        pitch_texel_(pitch_texel_of(surface.texture)),
        rows_(rows) {}

  // False where a pixel may be a near-tie, or there is no window.
  HWY_INLINE bool draw(const WindowRun& run, int32_t k, int32_t count_px, Pixel* to) const {
    const int32_t rows = kRows == 0 ? rows_ : kRows;
    const ptrdiff_t place = run.place[k];
    if (HWY_UNLIKELY(place < 0)) return false;
    auto [index, changes] = coarse_.texels(run.coarse[k]);
    if (InWindow::kClampsWindows || HWY_UNLIKELY(Coarse::any_near(changes))) {
      const LaneVectors lanes = batch_.lanes_from(run.u_fx16[k], run.v_fx16[k]);
      if (HWY_UNLIKELY(batch_.any_near(lanes))) return false;
      index = batch_.template window_index<kColumnBits>(lanes, rows);
    }
    store_pixels(pick<kColumnBits>(texels_ + place, pitch_texel_, rows, index), count_px, to);
    return true;
  }
  HWY_INLINE Lane to_anchor() const { return batch_.to_anchor(); }

 private:
  AffineBatch<InWindow> batch_;
  Coarse coarse_;
  const Pixel* texels_;
  ptrdiff_t pitch_texel_;
  int32_t rows_;
};

// Draws the run that begins with a pixel, and puts down the vectors that are left.
template <class Pixel, class Draw>
HWY_INLINE int32_t draw_run(const Draw& by, const WindowRun& run, const Span& rest, Pixel* row,
                            int32_t left_count, Left* left) {
  const auto leave = [&](int32_t px) HWY_ATTR {
    left->rest[static_cast<size_t>(left_count++)] = {rest.row, px, rest.right_px};
  };
  const int32_t count_px = HWY_MIN(rest.width_px(), kRun_px);
  const int32_t whole = count_px / kLanes, last_px = count_px % kLanes;
  Pixel* const to = row + rest.left_px;
  for (int32_t k = 0; k < whole; ++k) {
    if (HWY_UNLIKELY(!by.draw(run, k, kLanes, to + k * kLanes))) leave(rest.left_px + k * kLanes);
  }
  if (last_px != 0 && HWY_UNLIKELY(!by.draw(run, whole, last_px, to + whole * kLanes))) {
    leave(rest.left_px + whole * kLanes);
  }
  return left_count;
}

template <class Pixel, class InWindow, int kColumnBits, int32_t kRows>
HWY_NOINLINE void draw_windows(const AffineSpans& spans, const Surface& surface,
                               const WindowShape& shape, bool inside, Resume* at, Left* left) {
  const AffineField field = spans.field;
  using Draw = WindowDraw<Pixel, InWindow, kColumnBits, kRows>;
  const Draw by(spans, surface, shape.rows);
  const WindowFinder<typename Draw::Coarse> finder(field, surface, shape, inside);
  const Lane to_anchor = by.to_anchor();
  WindowRun run;
  int32_t i = at->row, px = at->px, left_count = 0;
  for (; i < spans.batch.rows; ++i, px = INT32_MIN) {
    const Span span = spans.batch.span(i);
    Pixel* const row = reinterpret_cast<Pixel*>(first_pixel(surface, {span.row, 0, 0}));
    for (px = HWY_MAX(px, span.left_px); px < span.right_px; px += kRun_px) {
      if (left_count > Left::kMost - kRunVectors) break;
      const Lane first = field.at(px, span.row);
      finder.find({first.u_fx32 + to_anchor.u_fx32, first.v_fx32 + to_anchor.v_fx32},
                  (span.right_px - px + kLanes - 1) / kLanes, &run);
      left_count = draw_run(by, run, {span.row, px, span.right_px}, row, left_count, left);
    }
    if (px < span.right_px) break;
  }
  left->count = left_count;
  *at = {i, px};
}

// Texels from windows, but for what does not lie in one. `inside`: the texture holds all texels.
template <class Pixel>
HWY_INLINE void draw_windows(const AffineSpans& spans, const Surface& surface,
                             const WindowShape& shape, bool inside, Resume* at, Left* left) {
  using Inside = Addressed<InsideVector>;
  constexpr int kBits = kWindowColumnBits;
  constexpr int32_t kOne = kRowsPerPermute, kTwo = 2 * kOne, kThree = 3 * kOne;
  if (surface.address == SELVAGE_ADDRESS_CLAMP && !inside) {
    const WindowShape wide{kBits, shape.rows};
    draw_windows<Pixel, Addressed<ClampVector>, kBits, 0>(spans, surface, wide, inside, at, left);
  } else if (shape.is_half()) {
    draw_windows<Pixel, Inside, kHalfColumnBits, kHalfWindowRows>(spans, surface, shape, inside, at,
                                                                  left);
  } else if (shape.rows == kOne) {
    draw_windows<Pixel, Inside, kBits, kOne>(spans, surface, shape, inside, at, left);
  } else if (shape.rows == kTwo) {
    draw_windows<Pixel, Inside, kBits, kTwo>(spans, surface, shape, inside, at, left);
  } else if (shape.rows == kThree) {
    draw_windows<Pixel, Inside, kBits, kThree>(spans, surface, shape, inside, at, left);
  } else {
    draw_windows<Pixel, Inside, kBits, 0>(spans, surface, shape, inside, at, left);
  }
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
