#include "mapper/filter_box.h"

#include <algorithm>
#include <cstddef>

#include "mapper/channels.h"
#include "mapper/layout.h"
#include "mapper/sums.h"

namespace selvage::mapper {
namespace {

// Consecutive texels of one axis, each with the same weight in 1/256 texel.
struct Run {
  int32_t first, count;
  int64_t weight_fx8;
};

// A side of a box as runs of addressed texels; several may name the same texel.
class Runs {
 public:
  Runs(int32_t begin_fx8, int32_t side_fx8, int32_t size_texel, selvage_address address) {
    if (address == SELVAGE_ADDRESS_CLAMP) {
      clamp(begin_fx8, side_fx8, size_texel);
    } else {
      wrap(begin_fx8, side_fx8, size_texel);
    }
  }

  static constexpr size_t kMost = 5;

  // Those of the longest run, and of all.
  [[nodiscard]] int32_t widest() const {
    int32_t most = 0;
    for (const Run& run : *this) most = std::max(most, run.count);
    return most;
  }
  [[nodiscard]] int32_t texels() const {
    int32_t all = 0;
    for (const Run& run : *this) all += run.count;
    return all;
  }

  [[nodiscard]] const Run* begin() const { return runs_.data(); }
  [[nodiscard]] const Run* end() const { return runs_.data() + count_; }

 private:
  void add(Run run) {
    if (run.count > 0) runs_[count_++] = run;
  }

  // The outermost texels stand for all that is beyond them.
  void clamp(int32_t begin_fx8, int32_t side_fx8, int32_t size_texel) {
    const int64_t end_fx8 = int64_t{begin_fx8} + side_fx8;
    const int32_t first = std::clamp<int32_t>(begin_fx8 >> kGridBits, 0, size_texel - 1);
    const int32_t last =
        std::clamp<int32_t>(static_cast<int32_t>((end_fx8 - 1) >> kGridBits), 0, size_texel - 1);
    if (first == last) return add({first, 1, side_fx8});
    add({first, 1, (int64_t{first} + 1) * kTexel_fx8 - begin_fx8});
    add({first + 1, last - first - 1, kTexel_fx8});
    add({last, 1, end_fx8 - int64_t{last} * kTexel_fx8});
  }

  // Whole periods cover each texel alike; the rest starts within the first period and ends within
  // the second.
  void wrap(int32_t begin_fx8, int32_t side_fx8, int32_t size_texel) {
    const int64_t period_fx8 = int64_t{size_texel} * kTexel_fx8;
    add({0, side_fx8 >= period_fx8 ? size_texel : 0, side_fx8 / period_fx8 * kTexel_fx8});
    const int64_t rest_fx8 = side_fx8 % period_fx8;
    if (rest_fx8 == 0) return;
    const int64_t start_fx8 = begin_fx8 - floor_div(begin_fx8, period_fx8) * period_fx8;
    const int64_t end_fx8 = start_fx8 + rest_fx8;
    const auto first = static_cast<int32_t>(start_fx8 >> kGridBits);
    const int64_t last = (end_fx8 - 1) >> kGridBits;
    if (first == last) return add({first, 1, rest_fx8});
    const auto into_period = [&](int64_t texel) {
      return static_cast<int32_t>(texel < size_texel ? texel : texel - size_texel);
    };
    add({first, 1, (int64_t{first} + 1) * kTexel_fx8 - start_fx8});
    const int64_t middle = int64_t{first} + 1;
    const int64_t to_end = std::clamp<int64_t>(size_texel - middle, 0, last - middle);
    add({into_period(middle), static_cast<int32_t>(to_end), kTexel_fx8});
    add({into_period(middle + to_end), static_cast<int32_t>(last - middle - to_end), kTexel_fx8});
    add({into_period(last), 1, end_fx8 - last * kTexel_fx8});
  }

  std::array<Run, kMost> runs_{};
  size_t count_ = 0;
};

// A row of texels, each as often as a side of a box covers it. A side is at most 2^24, so 32 bits
// hold a channel's sum.
static_assert(uint64_t{255} * kMostSide_fx8 <= UINT32_MAX);
template <class Layout>
[[nodiscard]] Channels row_sum(const char* row, const Runs& columns) {
  Channels total;
  for (const Run& run : columns) {
    Channels sum;
    for (int32_t s = run.first; s < run.first + run.count; ++s) {
      sum = sum + Channels::of(load_texel(row + Layout::column(s) * kPixelBytes));
    }
    total = total + sum * static_cast<uint32_t>(run.weight_fx8);
  }
  return total;
}

template <class Layout>
[[nodiscard]] BoxSum visit(const selvage_texture& texture, const Runs& columns, const Runs& rows) {
  const char* const texels = static_cast<const char*>(texture.texels);
  const ptrdiff_t pitch_texel = texture.pitch / kPixelBytes;
  BoxSum total{};
  for (const Run& run : rows) {
    const auto weight = static_cast<uint64_t>(run.weight_fx8);
    for (int32_t t = run.first; t < run.first + run.count; ++t) {
      const Channels sum =
          row_sum<Layout>(texels + Layout::row(t, pitch_texel) * kPixelBytes, columns);
      total[0] += weight * (sum.even & UINT32_MAX);
      total[1] += weight * (sum.odd & UINT32_MAX);
      total[2] += weight * (sum.even >> 32);
      total[3] += weight * (sum.odd >> 32);
    }
  }
  return total;
}

// The sums of each run of columns, over rows [0, t).
class Line {
 public:
  Line(const Sums& sums, const Runs& columns, int32_t t) {
    size_t i = 0;
    for (const Run& run : columns) {
      runs_[i++] = difference(sums.at(run.first + run.count, t), sums.at(run.first, t));
    }
  }
  [[nodiscard]] const ChannelSums& operator[](size_t run) const { return runs_[run]; }

 private:
  std::array<ChannelSums, Runs::kMost> runs_{};
};

// As visit(), out of sums: a rectangle of equal weights at a time. Rectangles of more than
// kMostSummed texels are cut into strips.
[[nodiscard]] BoxSum look_up(const Sums& sums, const Runs& columns, const Runs& rows) {
  static_assert(kMostSummed >= kMostSide_fx8 / kTexel_fx8, "a strip has a row");
  const auto strip = static_cast<int32_t>(kMostSummed / columns.widest());
  BoxSum total{};
  int32_t bottom = rows.begin()->first;
  Line lower(sums, columns, bottom);
  for (const Run& run : rows) {
    const auto row_weight = static_cast<uint64_t>(run.weight_fx8);
    const int32_t end = run.first + run.count;
    for (int32_t top = run.first; top < end; top = bottom) {
      const Line upper = top == bottom ? lower : Line(sums, columns, top);
      bottom = end - top < strip ? end : top + strip;
      lower = Line(sums, columns, bottom);
      size_t i = 0;
      for (const Run& column : columns) {
        const ChannelSums sum = difference(lower[i], upper[i]);
        ++i;
        const uint64_t weight = static_cast<uint64_t>(column.weight_fx8) * row_weight;
        for (size_t k = 0; k < total.size(); ++k) total[k] += weight * sum[k];
      }
    }
  }
  return total;
}

// floor(n / d) below 2^8, by a reciprocal: its product with n is off by less than 2^-43, so its
// floor by one at most. Several times as fast as to divide 64 bits. Whatever n is, for sums are
// memory of the caller, some number comes out.
[[nodiscard]] uint32_t quotient(uint64_t n, int64_t d, double reciprocal) {
  const double estimate = std::min(static_cast<double>(n) * reciprocal, 255.0);
  const auto near = static_cast<int32_t>(estimate);
  const auto rest = static_cast<int64_t>(n - static_cast<uint64_t>(near * d));
  return static_cast<uint32_t>(rest < 0 ? near - 1 : rest >= d ? near + 1 : near);
}

// Looking up costs as much as visiting so many texels. Measured: 80, where the sums are in a cache,
// 140 where they are not.
inline constexpr int64_t kWorthVisiting_texels = 128;

}  // namespace

BoxSum box_sum(const selvage_texture& texture, selvage_address address, const Box& box) {
  const Runs columns(box.left_fx8, box.width_fx8, texture.width, address);
  const Runs rows(box.top_fx8, box.height_fx8, texture.height, address);
  const bool many = int64_t{columns.texels()} * rows.texels() > kWorthVisiting_texels;
  if (many && texture.prepared != nullptr) return look_up(Sums(texture), columns, rows);
  return with_layout(texture.layout,
                     [&](auto layout) { return visit<decltype(layout)>(texture, columns, rows); });
}

uint32_t box_mean(const selvage_texture& texture, selvage_address address, const Box& box) {
  return box_mean(box_sum(texture, address, box), box);
}

uint32_t box_mean(const BoxSum& sum, const Box& box) {
  const int64_t area = int64_t{box.width_fx8} * box.height_fx8;
  const double reciprocal = 0.5 / static_cast<double>(area);
  uint32_t pixel = 0;
  for (size_t i = 0; i < sum.size(); ++i) {
    const uint64_t doubled = 2 * sum[i] + static_cast<uint64_t>(area);
    pixel |= quotient(doubled, 2 * area, reciprocal) << (8 * i);
  }
  return pixel;
}

}  // namespace selvage::mapper
