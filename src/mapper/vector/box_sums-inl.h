// The mean of a box out of a texture's sums, its channels side by side. Included once for each SIMD
// target.
//
// Of one row's entries E, 256 E[i] + f (E[i + 1] - E[i]) is what lies before column i + f / 256,
// times 256. A box is the difference of two such in each direction: as often as it covers each of
// its texels, in (1/256 texel)^2, it sums
//
//   65536 whole + 256 (f' last - f first)                   of all its rows,
//   + g' (256 whole + f' last - f first)                    of the row that it ends in,
//   -  g (256 whole + f' last - f first)                    of the row that it begins in,
//
// where it begins g below a row and f right of a column, and ends g' and f' so. With sides of 2^12
// texels at most `whole` fits 32 bits, each parenthesis 32 with its sign, and the sum 48.
#if defined(SELVAGE_VECTOR_BOX_SUMS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_VECTOR_BOX_SUMS_INL_H
#undef SELVAGE_VECTOR_BOX_SUMS_INL_H
#else
#define SELVAGE_VECTOR_BOX_SUMS_INL_H
#endif

#include "mapper/filter_box.h"
#include "mapper/sums.h"
#include "mapper/vector/box_mean-inl.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::mapper::HWY_NAMESPACE {
namespace {

inline constexpr int32_t kMostSummedSide_fx8 = 1 << kSummedSideBits;
static_assert(int64_t{1} << 2 * (kSummedSideBits - kGridBits) <= kMostSummed);
static_assert(int64_t{255} * kTexel_fx8 * (kMostSummedSide_fx8 >> kGridBits) <= INT32_MAX);

using DEntry = hn::CappedTag<uint32_t, 4>;
using DEntrySums = hn::Repartition<uint64_t, DEntry>;
using VEntry = hn::Vec<DEntry>;
using VEntrySums = hn::Vec<DEntrySums>;

// Channels 0 and 2, and channels 1 and 3.
struct ChannelPairs {
  VEntrySums even, odd;
};

// One end of a box along an axis: between two entries.
struct BoxEnd {
  int32_t entry, next;
  int32_t part_fx8;

  // Next to the last entry the part is 0, and any entry will do.
  [[nodiscard]] static HWY_INLINE BoxEnd of(int32_t at_fx8, int32_t size_texel) {
    const int32_t entry = at_fx8 >> kGridBits;
    return {entry, HWY_MIN(entry + 1, size_texel), at_fx8 & (kTexel_fx8 - 1)};
  }
};

class BoxSums {
 public:
  HWY_INLINE explicit BoxSums(const selvage_texture& texture)
      : entries_(static_cast<const char*>(texture.prepared)),
        pitch_bytes_(static_cast<ptrdiff_t>(SumsShape::of(texture).pitch_bytes)),
        width_texel_(texture.width),
        height_texel_(texture.height) {}

  [[nodiscard]] HWY_INLINE bool hold(const Box& box) const {
    return box.width_fx8 <= kMostSummedSide_fx8 && box.height_fx8 <= kMostSummedSide_fx8 &&
           box.left_fx8 >= 0 && box.top_fx8 >= 0 &&
           box.left_fx8 <= int64_t{width_texel_} * kTexel_fx8 - box.width_fx8 &&
           box.top_fx8 <= int64_t{height_texel_} * kTexel_fx8 - box.height_fx8;
  }

  // Of a box that they hold.
  HWY_INLINE void prefetch(const Box& box) const {
    const Ends ends = ends_of(box);
    for (const int32_t row : {ends.top.entry, ends.top.next, ends.bottom.entry, ends.bottom.next}) {
      __builtin_prefetch(at(ends.left.entry, row));
      __builtin_prefetch(at(ends.right.entry, row));
    }
  }
  [[nodiscard]] HWY_INLINE uint32_t mean(const Box& box) const {
    return rounded(sum(ends_of(box)), int64_t{box.width_fx8} * box.height_fx8);
  }

 private:
  struct Ends {
    BoxEnd left, right, top, bottom;
  };
  [[nodiscard]] HWY_INLINE Ends ends_of(const Box& box) const {
    return {BoxEnd::of(box.left_fx8, width_texel_),
            BoxEnd::of(box.left_fx8 + box.width_fx8, width_texel_),
            BoxEnd::of(box.top_fx8, height_texel_),
            BoxEnd::of(box.top_fx8 + box.height_fx8, height_texel_)};
  }

  // Of rows: the columns between a box's ends, the one that it begins in and the one it ends in.
  struct Columns {
    VEntry whole, first, last;
  };
  [[nodiscard]] HWY_INLINE Columns columns(const Ends& ends, int32_t row) const {
    const VEntry left = load(ends.left.entry, row), right = load(ends.right.entry, row);
    return {hn::Sub(right, left), hn::Sub(load(ends.left.next, row), left),
            hn::Sub(load(ends.right.next, row), right)};
  }
  [[nodiscard]] static HWY_INLINE Columns below(const Columns& upper, const Columns& lower) {
    return {hn::Sub(lower.whole, upper.whole), hn::Sub(lower.first, upper.first),
            hn::Sub(lower.last, upper.last)};
  }

  [[nodiscard]] HWY_INLINE ChannelPairs sum(const Ends& ends) const {
    const VEntry first_fx8 = set(ends.left.part_fx8), last_fx8 = set(ends.right.part_fx8);
    const auto parts = [&](const Columns& of) {
      return hn::Sub(hn::Mul(of.last, last_fx8), hn::Mul(of.first, first_fx8));
    };
    const auto row = [&](const Columns& of) {
      return hn::Add(hn::ShiftLeft<kGridBits>(of.whole), parts(of));
    };
    const Columns top = columns(ends, ends.top.entry), bottom = columns(ends, ends.bottom.entry);
    const Columns all = below(top, bottom);
    const VEntry end_row = row(below(bottom, columns(ends, ends.bottom.next)));
    const VEntry first_row = row(below(top, columns(ends, ends.top.next)));
    const VEntry inner_parts = parts(all);
    const auto total = [&](auto channels) {
      const VEntrySums inner = hn::Add(product(channels(all.whole), 1 << (2 * kGridBits)),
                                       signed_product(channels(inner_parts), kTexel_fx8));
      return hn::Sub(hn::Add(inner, product(channels(end_row), ends.bottom.part_fx8)),
                     product(channels(first_row), ends.top.part_fx8));
    };
    return {total([](VEntry even) { return even; }), total(odd_channels)};
  }

  // Where a product takes the even ones from.
  [[nodiscard]] static HWY_INLINE VEntry odd_channels(VEntry of) {
    return hn::BitCast(DEntry(), hn::ShiftRight<32>(hn::BitCast(DEntrySums(), of)));
  }
  [[nodiscard]] static HWY_INLINE VEntrySums product(VEntry even, int32_t weight) {
    return hn::MulEven(even, set(weight));
  }
  [[nodiscard]] static HWY_INLINE VEntrySums signed_product(VEntry even, int32_t weight) {
    const hn::RebindToSigned<DEntry> d;
    return hn::BitCast(DEntrySums(), hn::MulEven(hn::BitCast(d, even), hn::Set(d, weight)));
  }

  // sum / area, the nearest whole number, halves up: with a quarter more it is further from each
  // half than it is off (spec/proofs/box_mean.g). To add 2^52 is to round.
  [[nodiscard]] static HWY_INLINE uint32_t rounded(const ChannelPairs& sums, int64_t area_fx16) {
    const hn::Repartition<double, DEntry> d;
    const DEntrySums du;
    constexpr double kUnits = 4503599627370496;  // 2^52: whole numbers above it are its last bits
    const auto units = hn::Set(d, kUnits), quarter = hn::Set(d, 0.25);
    const auto reciprocal = hn::Set(d, 1.0 / static_cast<double>(area_fx16));
    const auto means = [&](VEntrySums sum) {
      const auto whole = hn::Sub(hn::BitCast(d, hn::Or(sum, hn::BitCast(du, units))), units);
      const auto mean = hn::Mul(hn::Add(whole, quarter), reciprocal);
      return hn::And(hn::BitCast(du, hn::Add(mean, units)), hn::Set(du, 0xFF));
    };
    const VEntrySums pairs = hn::Or(means(sums.even), hn::ShiftLeft<8>(means(sums.odd)));
    const hn::Repartition<uint8_t, DEntry> bytes;
    const auto upper = hn::ShiftRightBytes<6>(bytes, hn::BitCast(bytes, pairs));
    return hn::GetLane(hn::BitCast(DEntry(), hn::Or(hn::BitCast(bytes, pairs), upper)));
  }

  [[nodiscard]] static HWY_INLINE VEntry set(int32_t value) {
    return hn::Set(DEntry(), static_cast<uint32_t>(value));
  }
  [[nodiscard]] HWY_INLINE const char* at(int32_t s, int32_t t) const {
    return entries_ + t * pitch_bytes_ + s * ptrdiff_t{sizeof(ChannelSums)};
  }
  [[nodiscard]] HWY_INLINE VEntry load(int32_t s, int32_t t) const {
    return hn::LoadU(DEntry(), reinterpret_cast<const uint32_t*>(at(s, t)));
  }

  const char* entries_;
  ptrdiff_t pitch_bytes_;
  int32_t width_texel_, height_texel_;
};

// Of a texture that has sums: a box is looked up or visited, whichever is faster.
template <class Edge, class Layout>
class SummedMeans {
 public:
  HWY_INLINE explicit SummedMeans(const Surface& surface)
      : texture_(surface.texture),
        sums_(surface.texture),
        visited_(surface),
        least_summed_fx16_(least_summed_fx16(surface.texture)) {}

  [[nodiscard]] HWY_INLINE bool is_large() const { return visited_.is_large(); }
  HWY_INLINE void prefetch(const Box& box) const {
    if (!is_worth_summing(box)) return visited_.prefetch(box);
    if (sums_.hold(box)) sums_.prefetch(box);
  }

  HWY_INLINE uint32_t operator()(const Box& box) const {
    if (is_worth_summing(box)) {
      const Box placed{Edge::start(box.left_fx8, texture_.width),
                       Edge::start(box.top_fx8, texture_.height), box.width_fx8, box.height_fx8};
      if (HWY_LIKELY(sums_.hold(placed))) return summed(placed);
    }
    return visited_(box);
  }

 private:
  HWY_NOINLINE uint32_t summed(const Box& box) const { return sums_.mean(box); }

  [[nodiscard]] HWY_INLINE bool is_worth_summing(const Box& box) const {
    return int64_t{box.width_fx8} * box.height_fx8 >= least_summed_fx16_;
  }
  // Looking up costs as much as visiting so many texels: measured, where the sums, of 16 bytes a
  // texel, lie in some cache and where they do not.
  [[nodiscard]] static HWY_INLINE int64_t least_summed_fx16(const selvage_texture& texture) {
    constexpr int64_t kCached_texels = 1 << 21;
    const bool is_cached = int64_t{texture.width} * texture.height <= kCached_texels;
    return (is_cached ? 48 : 128) * kTexel_fx8 * kTexel_fx8;
  }

  const selvage_texture& texture_;
  BoxSums sums_;
  BoxMeans<Edge, Layout> visited_;
  int64_t least_summed_fx16_;
};

}  // namespace
}  // namespace selvage::mapper::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
