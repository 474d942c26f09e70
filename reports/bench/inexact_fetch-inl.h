// How the inexact loops fetch a vector of texels. Included once for each SIMD target.
#if defined(SELVAGE_REPORTS_INEXACT_FETCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_REPORTS_INEXACT_FETCH_INL_H
#undef SELVAGE_REPORTS_INEXACT_FETCH_INL_H
#else
#define SELVAGE_REPORTS_INEXACT_FETCH_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "reports/bench/inexact_polygon.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::reports::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using D32 = hn::CappedTag<int32_t, 16>;
using V32 = hn::Vec<D32>;
inline constexpr int32_t kLanes = static_cast<int32_t>(hn::MaxLanes(D32()));

// Stores with a mask, which leave other pixels alone, and gathers.
inline constexpr bool kHasMasks = HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3;

struct Texels {
  const int32_t* first;
  int32_t side, pitch;
};

// Of a vector: the columns and rows of its texels, in the texture for as many as are asked for.
struct Texel {
  V32 s, t;
};

// From its least column and row, so many rows that hold them all, by as many columns as lanes; no
// rows where that is not known, or too much.
struct Reach {
  int32_t least_s, least_t, rows;
};

HWY_INLINE void store_first(V32 pixels, int32_t count, int32_t* HWY_RESTRICT out) {
  if (HWY_LIKELY(count >= kLanes)) return hn::StoreU(pixels, D32(), out);
  hn::BlendedStore(pixels, hn::FirstN(D32(), static_cast<size_t>(count)), D32(), out);
}

HWY_INLINE V32 places(const Texels& texels, const Texel& at) {
  return hn::Add(hn::Mul(at.t, hn::Set(D32(), texels.pitch)), at.s);
}

struct Loads {
  HWY_INLINE Loads(const InexactPolygon& /*polygon*/, const Texels& /*texels*/) {}
  static constexpr int32_t rows_for(int32_t, int32_t, int32_t) { return 0; }
  static HWY_INLINE void fetch(const Texels& texels, const Texel& at, const Reach& /*reach*/,
                               int32_t count, int32_t* HWY_RESTRICT out) {
    HWY_ALIGN int32_t place[kLanes];
    hn::Store(places(texels, at), D32(), place);
    if (HWY_LIKELY(count >= kLanes)) {
#pragma GCC unroll 16
      for (int32_t i = 0; i < kLanes; ++i) out[i] = texels.first[place[i]];
      return;
    }
#pragma GCC unroll 4
    for (int32_t i = 0; i < count; ++i) out[i] = texels.first[place[i]];
  }
};

struct Gathers {
  HWY_INLINE Gathers(const InexactPolygon& /*polygon*/, const Texels& /*texels*/) {}
  static constexpr int32_t rows_for(int32_t, int32_t, int32_t) { return 0; }
  static HWY_INLINE void fetch(const Texels& texels, const Texel& at, const Reach& /*reach*/,
                               int32_t count, int32_t* HWY_RESTRICT out) {
    const D32 d;
    const auto asked = hn::FirstN(d, static_cast<size_t>(HWY_MIN(count, kLanes)));
    const V32 place = hn::IfThenElseZero(asked, places(texels, at));
    store_first(hn::GatherIndex(d, texels.first, place), count, out);
  }
};

// As many columns as lanes of a few rows of the texture, and texels picked from them by permutes.
struct Windows {
  HWY_INLINE Windows(const InexactPolygon& /*polygon*/, const Texels& /*texels*/) {}
#if HWY_TARGET == HWY_AVX3
  static constexpr int32_t kRowsAPermute = 2, kMostRows = 10;
#else
  static constexpr int32_t kRowsAPermute = 1, kMostRows = 4;
#endif

  // For texels that lie so far apart; 0 where that is too much.
  static constexpr int32_t rows_for(int32_t columns, int32_t rows, int32_t side) {
    const int32_t whole = (rows + kRowsAPermute - 1) / kRowsAPermute * kRowsAPermute;
    return columns <= HWY_MIN(kLanes, side) && whole <= HWY_MIN(kMostRows, side) ? whole : 0;
  }

  static HWY_INLINE V32 permute([[maybe_unused]] V32 row, [[maybe_unused]] V32 next, V32 index) {
#if HWY_TARGET == HWY_AVX3
    return V32{_mm512_permutex2var_epi32(row.raw, index.raw, next.raw)};
#elif HWY_TARGET == HWY_AVX2
    return V32{_mm256_permutevar8x32_epi32(row.raw, index.raw)};
#else
    return index;
#endif
  }
  static HWY_INLINE V32 row_at(const int32_t* texels) { return hn::LoadU(D32(), texels); }

  // The texels' numbers in a window that begins at (s, t), row by row.
  static HWY_INLINE V32 index(const Texel& at, int32_t s, int32_t t) {
    constexpr int kBits = kLanes == 16 ? 4 : 3;
    const V32 origin = hn::Set(D32(), t * (1 << kBits) + s);
    return hn::Sub(hn::Add(hn::ShiftLeft<kBits>(at.t), at.s), origin);
  }
  // Whether they are in that row of it or a later one.
  static HWY_INLINE auto from_row(int32_t row, V32 index) {
    return hn::Gt(index, hn::Set(D32(), row * kLanes - 1));
  }

  static HWY_INLINE void fetch(const Texels& texels, const Texel& at, const Reach& reach,
                               int32_t count, int32_t* HWY_RESTRICT out) {
    if (reach.rows == 0) return Loads::fetch(texels, at, reach, count, out);
    const int32_t s = HWY_MIN(reach.least_s, texels.side - kLanes);
    const int32_t t = HWY_MIN(reach.least_t, texels.side - reach.rows);
    const int32_t* window = texels.first + ptrdiff_t{t} * texels.pitch + s;
    const V32 wanted = index(at, s, t);
    V32 picked = permute(row_at(window), row_at(window + texels.pitch), wanted);
    for (int32_t row = kRowsAPermute; row < reach.rows; row += kRowsAPermute) {
      window += ptrdiff_t{kRowsAPermute} * texels.pitch;
      const V32 here = permute(row_at(window), row_at(window + texels.pitch), wanted);
      picked = hn::IfThenElse(from_row(row, wanted), here, picked);
    }
    store_first(picked, count, out);
  }
};

// One for a whole polygon, kept in registers.
template <int32_t kRows>
class OneWindow {
 public:
  HWY_INLINE OneWindow(const InexactPolygon& polygon, const Texels& texels)
      : s_(HWY_MIN(HWY_MAX(polygon.columns.first, 0), texels.side - kLanes)),
        t_(HWY_MIN(HWY_MAX(polygon.rows.first, 0), texels.side - kRows)) {
    const int32_t* const window = texels.first + ptrdiff_t{t_} * texels.pitch + s_;
#pragma GCC unroll 16
    for (int32_t row = 0; row < kRows; ++row)
      rows_[row] = Windows::row_at(window + ptrdiff_t{row} * texels.pitch);
  }

  static constexpr int32_t rows_for(int32_t, int32_t, int32_t) { return 0; }
  HWY_INLINE void fetch(const Texels& /*texels*/, const Texel& at, const Reach& /*reach*/,
                        int32_t count, int32_t* HWY_RESTRICT out) const {
    constexpr int32_t kStep = Windows::kRowsAPermute;
    const V32 wanted = Windows::index(at, s_, t_);
    V32 picked = Windows::permute(rows_[0], rows_[kStep - 1], wanted);
#pragma GCC unroll 16
    for (int32_t row = kStep; row < kRows; row += kStep) {
      const V32 here = Windows::permute(rows_[row], rows_[row + kStep - 1], wanted);
      picked = hn::IfThenElse(Windows::from_row(row, wanted), here, picked);
    }
    store_first(picked, count, out);
  }

 private:
  int32_t s_, t_;
  V32 rows_[kRows];
};

}  // namespace
}  // namespace selvage::reports::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
