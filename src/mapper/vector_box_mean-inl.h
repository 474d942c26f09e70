// The mean of a box of texels, its channels and several columns side by side. Included once for
// each SIMD target.
//
// A box inside the texture covers its first and its last row and column in part and those between
// in whole. Of each column, w_top top + 256 (sum of those between) + w_bottom bottom comes first,
// then the sum of these by the weights of the columns. All fits where no side is above 2^15 and the
// area not above 2^23 (1/256 texel)^2:
//
//   name              bits   bound
//   sum of rows       16     127 rows of 255, signed
//   column            23     255 * 2^15
//   sum               31     255 * 2^23, signed
//   mean              8      (sum + area / 2) / area, floored
#if defined(SELVAGE_VECTOR_BOX_MEAN_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BOX_MEAN_INL_H
#undef SELVAGE_VECTOR_BOX_MEAN_INL_H
#else
#define SELVAGE_VECTOR_BOX_MEAN_INL_H
#endif

#include <type_traits>

#include "mapper/channels.h"
#include "mapper/filter_box.h"
#include "mapper/vector_blend_mix-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

// Columns are summed a window at a time: 4 or 8 texels.
using DBytes = hn::CappedTag<uint8_t, 32>;
using DWords = hn::Repartition<int16_t, DBytes>;
using DSums = hn::Repartition<int32_t, DBytes>;
using VBytes = hn::Vec<DBytes>;
using VWords = hn::Vec<DWords>;
using VSums = hn::Vec<DSums>;
inline constexpr int32_t kBoxWindow_texel = static_cast<int32_t>(hn::MaxLanes(DSums()));

using DPixel = hn::CappedTag<int32_t, 4>;
using VPixel = hn::Vec<DPixel>;

inline constexpr int32_t kMostSmallSide_fx8 = (1 << 15) - 1;
inline constexpr int64_t kMostSmallArea_fx16 = 1 << 23;
static_assert(255 * ((kMostSmallSide_fx8 >> kGridBits) + 1) < 1 << 15);
static_assert(255 * kMostSmallArea_fx16 + kMostSmallArea_fx16 / 2 < int64_t{1} << 31);

// (sum + area / 2) / area, floored. With a quarter more it is no closer to a whole number than
// 2^-25, and what its three roundings come to is below 2^-43.
template <class V>
[[nodiscard]] HWY_INLINE uint32_t mean_of(V sums, int32_t area_fx16) {
  const hn::CappedTag<double, 4> d;
  const hn::Rebind<int32_t, decltype(d)> d32;
  const auto half = hn::Set(d, 0.5 * area_fx16 + 0.25);
  const auto reciprocal = hn::Set(d, 1.0 / area_fx16);
  const auto mean = [&](auto some) {
    return hn::DemoteTo(d32, hn::Mul(hn::Add(hn::PromoteTo(d, some), half), reciprocal));
  };
  V means;
  if constexpr (hn::MaxLanes(hn::CappedTag<double, 4>()) == 4) {
    means = mean(sums);
  } else {
    means = hn::Combine(DPixel(), mean(hn::UpperHalf(d32, sums)), mean(hn::LowerHalf(sums)));
  }
  const hn::Rebind<uint8_t, DPixel> d8;
  const hn::Repartition<uint32_t, decltype(d8)> whole;
  return hn::GetLane(hn::BitCast(whole, hn::DemoteTo(d8, means)));
}

template <class V>
[[nodiscard]] HWY_INLINE VPixel blocks_added(V sums) {
  if constexpr (hn::MaxLanes(hn::DFromV<V>()) == 4) {
    return sums;
  } else {
    return hn::Add(hn::LowerHalf(sums), hn::UpperHalf(DPixel(), sums));
  }
}

// A row of a window: 16 bits a channel, of the even and of the odd pairs of texels.
struct WindowRow {
  VWords even, odd;
};

// A box inside the texture: its texels, and its sides from the middle of texel 0 on.
struct InsideBox {
  int32_t first_column, last_column, first_row, last_row;
  int32_t left_fx8, right_fx8;
  int32_t top_weight_fx8, bottom_weight_fx8;
};

template <class Layout>
class BoxColumns {
 public:
  HWY_INLINE explicit BoxColumns(const selvage_texture& texture)
      : texels_(static_cast<const char*>(texture.texels)),
        pitch_texel_(texture.pitch / kPixelBytes),
        width_texel_(kTiled ? static_cast<int32_t>(units(texture.width, kTileSide_texel)) *
                                  kTileSide_texel
                            : texture.width) {}

  // The windows that hold a box's columns; 0 where the texture has no room for them.
  [[nodiscard]] HWY_INLINE int32_t windows(const InsideBox& box) const {
    const int32_t columns = box.last_column - aligned(box.first_column) + 1;
    const int32_t windows = (columns + kBoxWindow_texel - 1) / kBoxWindow_texel;
    return windows * kBoxWindow_texel <= width_texel_ ? windows : 0;
  }

  [[nodiscard]] HWY_INLINE VPixel sum(const InsideBox& box, int32_t windows) const {
    const DSums d;
    const int32_t last = width_texel_ - windows * kBoxWindow_texel;
    int32_t column = HWY_MIN(aligned(box.first_column), last);
    VSums sum = hn::Zero(d);
    for (; windows > 0; --windows, column += kBoxWindow_texel) {
      sum = hn::Add(sum, window_sum(box, column));
    }
    return blocks_added(sum);
  }

 private:
  static constexpr bool kTiled = std::is_same_v<Layout, Tiles>;
  // Texels that lie side by side whatever the row.
  [[nodiscard]] static HWY_INLINE int32_t aligned(int32_t column) {
    return kTiled ? column & ~Tiles::kInTile : column;
  }

  HWY_INLINE VBytes load(int32_t t, int32_t column) const {
    const char* const row = texels_ + Layout::row(t, pitch_texel_) * kPixelBytes;
    const auto at = [&](int32_t s) {
      return reinterpret_cast<const uint8_t*>(row + Layout::column(s) * kPixelBytes);
    };
    if constexpr (kTiled && kBoxWindow_texel == 8) {
      const hn::Half<DBytes> tile;
      return hn::Combine(DBytes(), hn::LoadU(tile, at(column + kTileSide_texel)),
                         hn::LoadU(tile, at(column)));
    } else {
      return hn::LoadU(DBytes(), at(column));
    }
  }
  HWY_INLINE WindowRow row(int32_t t, int32_t column) const {
    const VBytes bytes = load(t, column), zero = hn::Zero(DBytes());
    return {hn::BitCast(DWords(), hn::InterleaveLower(DBytes(), bytes, zero)),
            hn::BitCast(DWords(), hn::InterleaveUpper(DBytes(), bytes, zero))};
  }

  // Of columns by their weights: texels 0 and 4, 1 and 5 .. of the window in turn.
  HWY_INLINE VSums window_sum(const InsideBox& box, int32_t column) const {
    const DWords d;
    const WindowRow top = row(box.first_row, column), bottom = row(box.last_row, column);
    WindowRow between{hn::Zero(d), hn::Zero(d)};
    for (int32_t t = box.first_row + 1; t < box.last_row; ++t) {
      const WindowRow next = row(t, column);
      between = {hn::Add(between.even, next.even), hn::Add(between.odd, next.odd)};
    }
    const VSums weights = column_weights(box, column);
    const VWords ends =
        hn::BitCast(d, hn::Set(DSums(), box.bottom_weight_fx8 * (1 << 16) + box.top_weight_fx8));
    const VWords whole = hn::BitCast(d, hn::Set(DSums(), kTexel_fx8));
    const auto down = [&](VWords of_ends, VWords of_between) {
      return hn::Add(word_products(of_ends, ends), word_products(of_between, whole));
    };
    const VWords zero = hn::Zero(d);
    const VSums first = down(hn::InterleaveLower(d, top.even, bottom.even),
                             hn::InterleaveLower(d, between.even, zero));
    const VSums second = down(hn::InterleaveUpper(d, top.even, bottom.even),
                              hn::InterleaveUpper(d, between.even, zero));
    const VSums third = down(hn::InterleaveLower(d, top.odd, bottom.odd),
                             hn::InterleaveLower(d, between.odd, zero));
    const VSums fourth = down(hn::InterleaveUpper(d, top.odd, bottom.odd),
                              hn::InterleaveUpper(d, between.odd, zero));
    return hn::Add(hn::Add(hn::Mul(first, hn::Broadcast<0>(weights)),
                           hn::Mul(second, hn::Broadcast<1>(weights))),
                   hn::Add(hn::Mul(third, hn::Broadcast<2>(weights)),
                           hn::Mul(fourth, hn::Broadcast<3>(weights))));
  }

  // How much of each column of the window is in the box, 1/256 texel.
  static HWY_INLINE VSums column_weights(const InsideBox& box, int32_t column) {
    const DSums d;
    const VSums begin = hn::ShiftLeft<kGridBits>(hn::Iota(d, column));
    const auto covered = [&](int32_t end_fx8) {
      return hn::Min(hn::Max(hn::Sub(hn::Set(d, end_fx8), begin), hn::Zero(d)),
                     hn::Set(d, kTexel_fx8));
    };
    return hn::Sub(covered(box.right_fx8), covered(box.left_fx8));
  }

  const char* texels_;
  ptrdiff_t pitch_texel_;
  int32_t width_texel_;
};

// The start of a box's side, a whole number of periods further on where that brings it into the
// texture's first.
struct ClampStart {
  static HWY_INLINE int32_t start(int32_t begin_fx8, int32_t /*size_texel*/) { return begin_fx8; }
};
struct WrapStart {
  static HWY_INLINE int32_t start(int32_t begin_fx8, int32_t size_texel) {
    const int64_t period_fx8 = int64_t{size_texel} * kTexel_fx8;
    if (0 <= begin_fx8 && begin_fx8 < period_fx8) return begin_fx8;
    return static_cast<int32_t>(begin_fx8 - floor_div(begin_fx8, period_fx8) * period_fx8);
  }
};

template <class Start, class Layout>
class BoxMeans {
 public:
  HWY_INLINE explicit BoxMeans(const Surface& surface)
      : surface_(surface), columns_(surface.texture) {}

  HWY_INLINE uint32_t operator()(const Box& box) const {
    if (HWY_LIKELY(box.width_fx8 <= kMostSmallSide_fx8 && box.height_fx8 <= kMostSmallSide_fx8 &&
                   box.width_fx8 * box.height_fx8 <= kMostSmallArea_fx16)) {
      const int32_t left = Start::start(box.left_fx8, surface_.texture.width);
      const int32_t top = Start::start(box.top_fx8, surface_.texture.height);
      const int32_t right = left + box.width_fx8, bottom = top + box.height_fx8;
      InsideBox inside{left >> kGridBits,
                       (right - 1) >> kGridBits,
                       top >> kGridBits,
                       (bottom - 1) >> kGridBits,
                       left,
                       right,
                       0,
                       0};
      set_row_weights(top, bottom, &inside);
      const int32_t windows = is_inside(inside) ? columns_.windows(inside) : 0;
      if (HWY_LIKELY(windows > 0)) {
        return mean_of(columns_.sum(inside, windows), box.width_fx8 * box.height_fx8);
      }
    }
    return box_mean(surface_.texture, surface_.address, box);
  }

 private:
  HWY_INLINE bool is_inside(const InsideBox& box) const {
    return 0 <= box.first_column && box.last_column < surface_.texture.width &&
           0 <= box.first_row && box.last_row < surface_.texture.height;
  }
  // A box of one row has it at the top.
  static HWY_INLINE void set_row_weights(int32_t top, int32_t bottom, InsideBox* box) {
    const bool is_one = box->first_row == box->last_row;
    box->top_weight_fx8 = is_one ? bottom - top : kTexel_fx8 - (top & (kTexel_fx8 - 1));
    box->bottom_weight_fx8 = is_one ? 0 : ((bottom - 1) & (kTexel_fx8 - 1)) + 1;
  }

  const Surface& surface_;
  BoxColumns<Layout> columns_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
