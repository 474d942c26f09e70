// Vectors of pixels that hot loops leave to others, from their texels, of which no more is in
// doubt. Included once for each SIMD target.
#if defined(SELVAGE_VECTOR_LEFT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_LEFT_INL_H
#undef SELVAGE_VECTOR_LEFT_INL_H
#else
#define SELVAGE_VECTOR_LEFT_INL_H
#endif

#include <algorithm>
#include <array>

#include "mapper/vector/fetch-inl.h"
#include "mapper/vector/lanes-inl.h"
#include "mapper/vector/store-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Vectors of pixels that a hot loop leaves to others, so that it has no calls and keeps all it
// needs in registers: what is left of their span from there on.
struct Left {
  static constexpr int32_t kMost = 64;
  int32_t count = 0;
  std::array<Span, kMost> rest;

  [[nodiscard]] HWY_INLINE const Span& at(int32_t i) const { return rest[static_cast<size_t>(i)]; }
};

// Where a hot loop goes on: in this row of the batch, not before this pixel.
struct Resume {
  int32_t row = 0, px = INT32_MIN;
};

// What is left of some vectors after others, to be drawn at once.
class KeptLeft {
 public:
  // Calls draw(left) with what was kept before, where there is no room for more.
  template <class Draw>
  HWY_INLINE void keep(const Left& left, const Draw& draw) {
    if (kept_.count + left.count > Left::kMost) finish(draw);
    std::copy_n(left.rest.begin(), left.count, kept_.rest.begin() + kept_.count);
    kept_.count += left.count;
  }
  HWY_INLINE void clear() { kept_.count = 0; }
  // And here with all of it, if there is any.
  template <class Draw>
  HWY_INLINE void finish(const Draw& draw) {
    if (kept_.count != 0) draw(kept_);
    clear();
  }

 private:
  Left kept_;
};

// Whether so many of some vectors hold near-ties that what decides all pixels costs less.
inline constexpr int32_t kLeastNear = 4;
[[nodiscard]] constexpr bool are_many(int32_t near, int32_t of_vectors) {
  constexpr int32_t kManyOf = 4;
  return near >= kLeastNear && near * kManyOf > of_vectors;
}

// Whether so many of some rows' vectors do, or of pieces of rows, that boundaries for all cost
// less.
[[nodiscard]] HWY_INLINE bool are_most(int32_t near, int32_t of_rows) {
  return near >= kLeastNear && 2 * near > of_rows;
}

// A window for a vector: its first texels, and its rows, 0 where there is none.
struct LeftWindow {
  int32_t s, t, rows;
};

// The texels of some vectors: what decides near-ties need not know how pixels are made of them.
struct DecidedTexels {
  HWY_ALIGN int32_t s[Left::kMost * kLanes], t[Left::kMost * kLanes];

  HWY_INLINE void put(int32_t i, const TexelVectors& texels) {
    hn::Store(texels.s, D32(), s + i * kLanes);
    hn::Store(texels.t, D32(), t + i * kLanes);
  }
  [[nodiscard]] HWY_INLINE TexelVectors at(int32_t i) const {
    return {hn::Load(D32(), s + i * kLanes), hn::Load(D32(), t + i * kLanes)};
  }
};

// Of those that are left, and how many rows their windows have.
struct LeftTexels : DecidedTexels {
  int32_t window_rows[Left::kMost];

  HWY_INLINE void put(int32_t i, const TexelVectors& texels, int32_t rows) {
    DecidedTexels::put(i, texels);
    window_rows[i] = rows;
  }
  // A map is monotonic along a row. Where a row ends before, what is behind it may mean nothing.
  [[nodiscard]] HWY_INLINE LeftWindow window(int32_t i) const {
    const auto least = [](const int32_t* texel) { return HWY_MIN(texel[0], texel[kLanes - 1]); };
    return {least(s + i * kLanes), least(t + i * kLanes), window_rows[i]};
  }
};

// Draws vectors of right texels.
template <class Address>
class TexelDraw {
 public:
  explicit HWY_INLINE TexelDraw(const Surface& surface)
      : surface_(surface), extent_(extent_of(surface.texture)) {}

  // A vector, or what there is left of one at a row's end: from a window, or, where there is none,
  // by a load for each pixel.
  template <class Pixel>
  HWY_INLINE void draw(const Span& rest, const TexelVectors& texels, const LeftWindow& at) const {
    const auto* const from = static_cast<const Pixel*>(surface_.texture.texels);
    char* const to = first_pixel(surface_, rest);
    if (kHasWindows && at.rows != 0 &&
        draw_window(texels, at, from, rest.width_px(), reinterpret_cast<Pixel*>(to))) {
      return;
    }
    fetch_vector<Pixel>(from, Address::place(texels.s, texels.t, extent_), rest.width_px(), to);
  }

 private:
  // False where the window does not hold them.
  template <class Pixel>
  HWY_INLINE bool draw_window(const TexelVectors& texels, const LeftWindow& at, const Pixel* from,
                              int32_t count_px, Pixel* to) const {
    const D32 d;
    const int32_t last_column = extent_.width_texel - kLanes;
    const int32_t last_row = extent_.height_texel - at.rows;
    const Origin s = before(Address::origin(at.s, last_column, extent_.width_texel), last_column);
    const Origin t = before(Address::origin(at.t, last_row, extent_.height_texel), last_row);
    const V32 column =
        hn::Sub(Address::window_texel(texels.s, extent_.width_texel), hn::Set(d, s.texel));
    const V32 row =
        hn::Sub(Address::window_texel(texels.t, extent_.height_texel), hn::Set(d, t.texel));
    const V32 high = hn::Or(hn::AndNot(hn::Set(d, kLanes - 1), column), hn::ShiftRight<31>(row));
    const auto outside = hn::Or(hn::Ne(high, hn::Zero(d)), hn::Gt(row, hn::Set(d, at.rows - 1)));
    if (!hn::AllFalse(d, outside)) return false;
    const Pixel* const window = from + t.index * ptrdiff_t{extent_.pitch_texel} + s.index;
    store_pixels(pick<kWindowColumnBits>(window, extent_.pitch_texel, at.rows,
                                         hn::Add(hn::ShiftLeft<kWindowColumnBits>(row), column)),
                 count_px, to);
    return true;
  }
  // Moved to where the window lies in the texture.
  static HWY_INLINE Origin before(const Origin& origin, int32_t last) {
    const int32_t by = HWY_MAX(origin.index - last, 0);
    return {origin.texel - by, origin.index - by};
  }

  const Surface& surface_;
  Extent extent_;
};

template <class Pixel, class Address>
HWY_NOINLINE void draw_left(const Left& left, const LeftTexels& texels, const Surface& surface) {
  const TexelDraw<Address> draw(surface);
  for (int32_t i = 0; i < left.count; ++i) {
    draw.template draw<Pixel>(left.at(i), texels.at(i), texels.window(i));
  }
}

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
