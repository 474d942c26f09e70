// The mean of a box of texels, its channels and several columns side by side. Included once for
// each SIMD target.
//
// A box inside the texture covers its first row and its last one or two in part, and those between
// in whole: of how many it takes parts depends on where it lies, of how many it may take parts on
// its height alone, so that loops are as long for each box of a polygon. Each column of texels is
// summed first, by the weights of the rows, then these by the weights of the columns. All fits
// where the area is not above 2^23 (1/256 texel)^2, so that no side is above 2^15:
//
//   name              bits   bound
//   sum of rows       16     126 rows of 255, signed
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
#include "mapper/vector/blend_mix-inl.h"
#include "mapper/vector/box_edges-inl.h"
#include "mapper/vector/box_rounding-inl.h"
#include "mapper/vector/words-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

inline constexpr int64_t kMostSmallArea_fx16 = 1 << 23;
static_assert(255 * (kMostSmallArea_fx16 / kLeastSide_fx8 >> kGridBits) < 1 << 15);
// Parts of a box that is no wider are small, and at least so high that they take three rows.
inline constexpr int32_t kMostDividedSide_fx8 = 60 * kTexel_fx8;
inline constexpr int64_t kMostPart_fx16 = kMostSmallArea_fx16 - kMostDividedSide_fx8;
static_assert(kMostPart_fx16 / (2 * kMostDividedSide_fx8) >= kTexel_fx8 + 2);
static_assert(255 * kMostSmallArea_fx16 + kMostSmallArea_fx16 / 2 < int64_t{1} << 31);

// A row of a window: 16 bits a channel, of the even and of the odd pairs of texels.
struct WindowRow {
  VWords even, odd;
};

template <class Layout>
class BoxColumns {
 public:
  HWY_INLINE explicit BoxColumns(const selvage_texture& texture)
      : texels_(static_cast<const char*>(texture.texels)),
        pitch_texel_(texture.pitch / kPixelBytes),
        width_texel_(texture.width),
        height_texel_(texture.height),
        padded_texel_(kTiled ? static_cast<int32_t>(units(texture.width, kTileSide_texel)) *
                                   kTileSide_texel
                             : texture.width) {}

  HWY_INLINE void prefetch(int32_t t, int32_t s) const {
    __builtin_prefetch(texels_ + (Layout::row(t, pitch_texel_) + Layout::column(s)) * kPixelBytes);
  }

  // The windows that hold a box's columns.
  [[nodiscard]] static HWY_INLINE int32_t windows(const BoxSide& columns) {
    const int32_t before = kTiled ? kTileSide_texel - 1 : 0;
    return static_cast<int32_t>(units(columns.texels + before, kBoxWindow_texel));
  }
  [[nodiscard]] HWY_INLINE bool has_room_for(int32_t windows) const {
    return windows * kBoxWindow_texel <= padded_texel_;
  }

  // Where the windows begin: in the texture, and so that they hold the columns, addressed.
  [[nodiscard]] HWY_INLINE int32_t begin(const BoxSide& columns, int32_t windows) const {
    const int32_t last = padded_texel_ - windows * kBoxWindow_texel;
    return HWY_MAX(HWY_MIN(aligned(columns.first_texel), last), 0);
  }

  // Of a box inside the texture, or of one that is not, where `Edge` tells what is there.
  template <class Edge>
  [[nodiscard]] HWY_INLINE VPixel sum(const BoxSide& columns, const BoxSide& rows,
                                      int32_t windows) const {
    int32_t column = begin(columns, windows);
    VSums sum = window_sum<Edge>(columns, rows, column);
    while (--windows > 0) {
      column += kBoxWindow_texel;
      sum = hn::Add(sum, window_sum<Edge>(columns, rows, column));
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
  template <class Edge>
  HWY_INLINE VSums window_sum(const BoxSide& columns, const BoxSide& rows, int32_t column) const {
    const DWords d;
    const int32_t last = rows.texels - 1, bottom = rows.first_texel + last;
    const auto row_at = [&](int32_t t) { return row(Edge::row(t, height_texel_), column); };
    const WindowRow first = row_at(rows.first_texel), end = row_at(bottom);
    const WindowRow before = row_at(bottom - 1);
    WindowRow between{hn::Zero(d), hn::Zero(d)};
    for (int32_t t = rows.first_texel + 1; t < bottom - 1; ++t) {
      const WindowRow next = row_at(t);
      between = {hn::Add(between.even, next.even), hn::Add(between.odd, next.odd)};
    }
    // How far the box reaches into the last row, or how far it ends before it.
    const int32_t reach_fx8 = rows.part_fx8 + rows.side_fx8 - last * kTexel_fx8;
    const int32_t end_weight = HWY_MAX(reach_fx8, 0);
    const VWords ends = pair(kTexel_fx8 - rows.part_fx8, end_weight);
    const VWords inner = pair(kTexel_fx8, kTexel_fx8 + reach_fx8 - end_weight);
    const VSums weights = column_weights<Edge>(columns, column);
    const auto lower = [&](VWords a, VWords b, VWords of) {
      return word_products(hn::InterleaveLower(d, a, b), of);
    };
    const auto upper = [&](VWords a, VWords b, VWords of) {
      return word_products(hn::InterleaveUpper(d, a, b), of);
    };
    VSums sum =
        hn::Mul(hn::Add(lower(first.even, end.even, ends), lower(between.even, before.even, inner)),
                hn::Broadcast<0>(weights));
    sum = hn::Add(sum, hn::Mul(hn::Add(upper(first.even, end.even, ends),
                                       upper(between.even, before.even, inner)),
                               hn::Broadcast<1>(weights)));
    sum = hn::Add(sum, hn::Mul(hn::Add(lower(first.odd, end.odd, ends),
                                       lower(between.odd, before.odd, inner)),
                               hn::Broadcast<2>(weights)));
    return hn::Add(sum, hn::Mul(hn::Add(upper(first.odd, end.odd, ends),
                                        upper(between.odd, before.odd, inner)),
                                hn::Broadcast<3>(weights)));
  }

  static HWY_INLINE VWords pair(int32_t low, int32_t high) {
    return hn::BitCast(DWords(), hn::Set(DSums(), high * (1 << 16) + low));
  }

  // How much of each column of the window is in the box, 1/256 texel.
  template <class Edge>
  HWY_INLINE VSums column_weights(const BoxSide& columns, int32_t column) const {
    const DSums d;
    const VSums texel = hn::Iota(d, 0), texel_fx8 = hn::ShiftLeft<kGridBits>(texel);
    const auto reach = Edge::reach(hn::Add(texel, hn::Set(d, column)), width_texel_);
    const int32_t begin_fx8 = columns.part_fx8 + (columns.first_texel - column) * kTexel_fx8;
    const auto covered = [&](int32_t end_fx8) {
      return hn::Min(hn::Max(hn::Sub(hn::Set(d, end_fx8), texel_fx8), reach.least_fx8),
                     reach.most_fx8);
    };
    return hn::Sub(covered(begin_fx8 + columns.side_fx8), covered(begin_fx8));
  }

  const char* texels_;
  ptrdiff_t pitch_texel_;
  int32_t width_texel_, height_texel_;
  int32_t padded_texel_;  // the width, with what tiles have beyond it
};

template <class Edge, class Layout>
class BoxMeans {
 public:
  HWY_INLINE explicit BoxMeans(const Surface& surface)
      : surface_(surface),
        columns_(surface.texture),
        is_large_(int64_t{surface.texture.width} * surface.texture.height > kLarge_texels) {}

  [[nodiscard]] HWY_INLINE bool is_large() const { return is_large_; }
  // Of a box inside the texture: others are few.
  HWY_INLINE void prefetch(const Box& box) const {
    const BoxSide columns = BoxSide::of(box.left_fx8, box.width_fx8);
    const BoxSide rows = BoxSide::of(box.top_fx8, box.height_fx8);
    const selvage_texture& texture = surface_.texture;
    if (!columns.is_inside(texture.width) || !rows.is_inside(texture.height)) return;
    const int32_t s = columns.first_texel + columns.texels / 2;
    for (int32_t i = 0; i < rows.texels; ++i) columns_.prefetch(rows.first_texel + i, s);
  }

  HWY_INLINE uint32_t operator()(const Box& box) const {
    const int64_t area_fx16 = int64_t{box.width_fx8} * box.height_fx8;
    if (HWY_UNLIKELY(area_fx16 > kMostSmallArea_fx16)) return large(box, area_fx16);
    const selvage_texture& texture = surface_.texture;
    const BoxSide columns = columns_of(box), rows = rows_of(box);
    const int32_t windows = BoxColumns<Layout>::windows(columns);
    if (HWY_UNLIKELY(!columns_.has_room_for(windows))) {
      return box_mean(texture, surface_.address, box);
    }
    if (HWY_UNLIKELY(!columns.is_inside(texture.width) || !rows.is_inside(texture.height))) {
      return beyond(box, columns, rows, windows);
    }
    return mean_of(columns_.template sum<NoEdge>(columns, rows, windows),
                   static_cast<int32_t>(area_fx16));
  }

 private:
  [[nodiscard]] HWY_INLINE BoxSide columns_of(const Box& box) const {
    return BoxSide::of(Edge::start(box.left_fx8, surface_.texture.width), box.width_fx8);
  }
  // The first, some between, and the last two.
  [[nodiscard]] HWY_INLINE BoxSide rows_of(const Box& box) const {
    BoxSide rows = BoxSide::of(Edge::start(box.top_fx8, surface_.texture.height), box.height_fx8);
    rows.texels = HWY_MAX(rows.texels, 3);
    return rows;
  }

  // Without sums, and inside the texture: in parts that are small and as high, one below the other.
  HWY_NOINLINE uint32_t large(const Box& box, int64_t area_fx16) const {
    const selvage_texture& texture = surface_.texture;
    const BoxSide columns = columns_of(box);
    const int32_t windows = BoxColumns<Layout>::windows(columns);
    if (texture.prepared != nullptr || box.width_fx8 > kMostDividedSide_fx8 ||
        !columns.is_inside(texture.width) || !columns_.has_room_for(windows)) {
      return box_mean(texture, surface_.address, box);
    }
    const int32_t top_fx8 = Edge::start(box.top_fx8, texture.height);
    const int64_t parts = area_fx16 / kMostPart_fx16 + 1;
    BoxSum sum{};
    for (int64_t part = 0; part < parts; ++part) {
      const auto begin_fx8 = static_cast<int32_t>(box.height_fx8 * part / parts);
      const auto end_fx8 = static_cast<int32_t>(box.height_fx8 * (part + 1) / parts);
      const BoxSide rows = BoxSide::of(top_fx8 + begin_fx8, end_fx8 - begin_fx8);
      if (!rows.is_inside(texture.height)) return box_mean(texture, surface_.address, box);
      add(columns_.template sum<NoEdge>(columns, rows, windows), &sum);
    }
    return box_mean(sum, box);
  }
  static HWY_INLINE void add(VPixel part, BoxSum* sum) {
    HWY_ALIGN int32_t channels[4];
    hn::Store(part, DPixel(), channels);
    for (size_t i = 0; i < 4; ++i) (*sum)[i] += static_cast<uint32_t>(channels[i]);
  }

  HWY_NOINLINE uint32_t beyond(const Box& box, const BoxSide& columns, const BoxSide& rows,
                               int32_t windows) const {
    if (!Edge::fits(columns, rows, surface_.texture)) {
      return box_mean(surface_.texture, surface_.address, box);
    }
    return mean_of(columns_.template sum<Edge>(columns, rows, windows),
                   box.width_fx8 * box.height_fx8);
  }

  static constexpr int64_t kLarge_texels = 1 << 17;  // half a megabyte

  const Surface& surface_;
  BoxColumns<Layout> columns_;
  bool is_large_;
};

// Of a texture so long that 32 bits do not count 1/256 texels of it.
class PlainMeans {
 public:
  HWY_INLINE explicit PlainMeans(const Surface& surface) : surface_(surface) {}
  [[nodiscard]] static HWY_INLINE bool is_for(const selvage_texture& texture) {
    return HWY_MAX(texture.width, texture.height) > INT32_MAX >> kGridBits;
  }

  [[nodiscard]] HWY_INLINE bool is_large() const { return false; }
  HWY_INLINE void prefetch(const Box& /*box*/) const {}
  HWY_INLINE uint32_t operator()(const Box& box) const {
    return box_mean(surface_.texture, surface_.address, box);
  }

 private:
  const Surface& surface_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
