// The rows of the inexact loops. Included once for each SIMD target.
#if defined(SELVAGE_REPORTS_INEXACT_ROWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SELVAGE_REPORTS_INEXACT_ROWS_INL_H
#undef SELVAGE_REPORTS_INEXACT_ROWS_INL_H
#else
#define SELVAGE_REPORTS_INEXACT_ROWS_INL_H
#endif

#include <cmath>

#include "reports/bench/inexact_fetch-inl.h"
#include "reports/bench/inexact_loops.h"

HWY_BEFORE_NAMESPACE();
namespace selvage::reports::HWY_NAMESPACE {
namespace {

using DF = hn::RebindToFloat<D32>;
using VF = hn::Vec<DF>;
inline constexpr int kFraction = 16;

HWY_INLINE V32 clamped(V32 texel, int32_t side) {
  return hn::Min(hn::Max(texel, hn::Zero(D32())), hn::Set(D32(), side - 1));
}

struct Run {
  int32_t row, left_px, count;
};

// Sums wrap: what is far outside the texture may come from anywhere, but is in it when clamped.
[[nodiscard]] HWY_INLINE int32_t sum(int32_t a, int32_t b) {
  return static_cast<int32_t>(static_cast<uint32_t>(a) + static_cast<uint32_t>(b));
}
[[nodiscard]] HWY_INLINE int32_t product(int32_t a, int32_t b) {
  return static_cast<int32_t>(static_cast<uint32_t>(a) * static_cast<uint32_t>(b));
}
[[nodiscard]] HWY_INLINE int32_t fx16(double value) {
  return static_cast<int32_t>(static_cast<int64_t>(value));
}

// Along x: where lanes are, and a vector's worth of steps.
class Axis {
 public:
  HWY_INLINE explicit Axis(const Plane& plane)
      : plane_(plane),
        step_(fx16(plane.dx)),
        to_least_(step_ < 0 ? product(kLanes - 1, step_) : 0),
        offsets_(hn::Mul(hn::Iota(D32(), 0), hn::Set(D32(), step_))) {}

  HWY_INLINE int32_t start(const Run& run) const { return fx16(plane_.at(run.left_px, run.row)); }
  HWY_INLINE int32_t after(int32_t start, int32_t px) const {
    return sum(start, product(px, step_));
  }
  // Of a vector.
  HWY_INLINE int32_t least(int32_t start) const { return sum(start, to_least_); }
  // That the texels of a vector are in, at most.
  HWY_INLINE int32_t extent_texel() const {
    const double rise_fx16 = (kLanes - 1) * std::abs(static_cast<double>(step_));
    return static_cast<int32_t>(HWY_MIN(std::ceil(rise_fx16 / 65536), 65536.0)) + 1;
  }
  HWY_INLINE V32 lanes(int32_t start) const { return hn::Add(hn::Set(D32(), start), offsets_); }

 private:
  Plane plane_;
  int32_t step_, to_least_;
  V32 offsets_;
};

[[nodiscard]] HWY_INLINE bool is_inside(int32_t start, int32_t last, int32_t side) {
  const auto end = static_cast<uint32_t>(side) << kFraction;
  return static_cast<uint32_t>(start) < end && static_cast<uint32_t>(last) < end;
}

template <class Fetch>
class Affine {
 public:
  HWY_INLINE Affine(const InexactPolygon& polygon, const Texels& texels)
      : u_(polygon.u),
        v_(polygon.v),
        fetch_(polygon, texels),
        rows_(Fetch::rows_for(u_.extent_texel(), v_.extent_texel(), texels.side)) {}

  HWY_INLINE void draw(const Run& run, const Texels& texels, int32_t* HWY_RESTRICT out) const {
    const int32_t u = u_.start(run), v = v_.start(run);
    if (HWY_LIKELY(is_inside(u, u_.after(u, run.count - 1), texels.side) &&
                   is_inside(v, v_.after(v, run.count - 1), texels.side)))
      return draw_vectors<true>(u, v, run.count, texels, out);
    draw_vectors<false>(u, v, run.count, texels, out);
  }

 private:
  template <bool kInside>
  HWY_INLINE void draw_vectors(int32_t u, int32_t v, int32_t count, const Texels& texels,
                               int32_t* HWY_RESTRICT out) const {
    const auto column = [&](V32 lanes) HWY_ATTR {
      const V32 texel = hn::ShiftRight<kFraction>(lanes);
      return kInside ? texel : clamped(texel, texels.side);
    };
    for (; count > 0; count -= kLanes, out += kLanes) {
      const Texel at{column(u_.lanes(u)), column(v_.lanes(v))};
      const Reach reach{HWY_MAX(u_.least(u) >> kFraction, 0), HWY_MAX(v_.least(v) >> kFraction, 0),
                        rows_};
      fetch_.fetch(texels, at, reach, count, out);
      u = u_.after(u, kLanes);
      v = v_.after(v, kLanes);
    }
  }

  Axis u_, v_;
  Fetch fetch_;
  int32_t rows_;
};

template <class Fetch>
class Projective {
 public:
  HWY_INLINE Projective(const InexactPolygon& polygon, const Texels& texels)
      : polygon_(polygon), fetch_(polygon, texels) {}

  HWY_INLINE void draw(const Run& run, const Texels& texels, int32_t* HWY_RESTRICT out) const {
    const Row row(polygon_, run);
    const Reach steepest = steepest_reach(run, texels.side);
    int32_t x = 0;
    for (; steepest.rows != 0 && x + kLanes <= run.count; x += kLanes) {
      const Texel texel = row.texel(x, texels.side);
      const Reach reach{steepest.least_s == 0 ? hn::GetLane(texel.s) : last_lane(texel.s),
                        steepest.least_t == 0 ? hn::GetLane(texel.t) : last_lane(texel.t),
                        steepest.rows};
      fetch_.fetch(texels, texel, reach, kLanes, out + x);
    }
    for (; x < run.count; x += kLanes) {
      const Texel texel = row.texel(x, texels.side);
      fetch_.fetch(texels, texel, reach_of(texel, run.count - x, texels.side), run.count - x,
                   out + x);
    }
  }

 private:
  // Numerators and denominator along a row.
  class Row {
   public:
    HWY_INLINE Row(const InexactPolygon& polygon, const Run& run)
        : u_(polygon.u, run), v_(polygon.v, run), q_(polygon.q, run) {}

    HWY_INLINE Texel texel(int32_t x, int32_t side) const {
      const DF d;
      const VF i = hn::Add(hn::Iota(d, 0.0F), hn::Set(d, static_cast<float>(x)));
      const VF w = hn::Div(hn::Set(d, 1.0F), q_.at(i));
      return {clamped(hn::ConvertTo(D32(), hn::Mul(u_.at(i), w)), side),
              clamped(hn::ConvertTo(D32(), hn::Mul(v_.at(i), w)), side)};
    }

   private:
    struct Line {
      HWY_INLINE Line(const Plane& plane, const Run& run)
          : start(hn::Set(DF(), static_cast<float>(plane.at(run.left_px, run.row)))),
            step(hn::Set(DF(), static_cast<float>(plane.dx))) {}
      HWY_INLINE VF at(VF i) const { return hn::Add(hn::Mul(i, step), start); }
      VF start, step;
    };
    Line u_, v_, q_;
  };

  static HWY_INLINE int32_t last_lane(V32 lanes) { return hn::GetLane(hn::Reverse(D32(), lanes)); }

  // Of whole vectors of a long row: the number of the lane of least column and of least row is 0 or
  // the last, and the rows that a vector needs where it is steepest, which is where q is least.
  HWY_INLINE Reach steepest_reach(const Run& run, int32_t side) const {
    constexpr int32_t kLong_px = 4 * kLanes;
    if (Fetch::rows_for(1, 1, kLanes) == 0 || run.count < kLong_px) return {};
    const double q = polygon_.q.at(run.left_px, run.row);
    const double least_q = HWY_MIN(q, q + polygon_.q.dx * (run.count - 1));
    const auto turn = [&](const Plane& plane) {
      return plane.dx * q - plane.at(run.left_px, run.row) * polygon_.q.dx;
    };
    const auto extent = [&](double steepness) {
      const double rise = (kLanes - 1) * std::abs(steepness) / (least_q * least_q);
      return static_cast<int32_t>(HWY_MIN(std::ceil(rise), 65536.0)) + 1;
    };
    const double u = turn(polygon_.u), v = turn(polygon_.v);
    return {u < 0, v < 0, Fetch::rows_for(extent(u), extent(v), side)};
  }

  // A map turns along no line: the texels between the first and the last lie between.
  static HWY_INLINE Reach reach_of(const Texel& texel, int32_t count, int32_t side) {
    if constexpr (Fetch::rows_for(1, 1, kLanes) == 0) return {};
    HWY_ALIGN int32_t s[kLanes], t[kLanes];
    hn::Store(texel.s, D32(), s);
    hn::Store(texel.t, D32(), t);
    const int32_t last = HWY_MIN(count, kLanes) - 1;
    const int32_t least_s = HWY_MIN(s[0], s[last]), least_t = HWY_MIN(t[0], t[last]);
    const int32_t columns = HWY_MAX(s[0], s[last]) - least_s + 1;
    const int32_t rows = HWY_MAX(t[0], t[last]) - least_t + 1;
    return {least_s, least_t, Fetch::rows_for(columns, rows, side)};
  }

  const InexactPolygon& polygon_;
  Fetch fetch_;
};

[[nodiscard]] HWY_INLINE int32_t column_of_edge(const InexactEdge& edge) {
  constexpr int64_t kAlmostOne_fx32 = UINT32_MAX;
  return static_cast<int32_t>((edge.x_fx32 + kAlmostOne_fx32) >> 32);
}

template <class Spans>
HWY_INLINE void draw_rows(const InexactPolygon& polygon, const Texture& texture, Target& target) {
  if (polygon.edge_count < 2) return;
  const Texels texels{reinterpret_cast<const int32_t*>(texture.texels.data()), texture.side_texel,
                      texture.pitch_texel};
  const Spans spans(polygon, texels);
  InexactEdge a = polygon.edges[0], b = polygon.edges[1];
  size_t next = 2;
  for (int32_t row = a.first_row_px;; ++row) {
    for (InexactEdge* const edge : {&a, &b}) {
      if (row != edge->end_row_px) continue;
      if (next == polygon.edge_count) return;
      *edge = polygon.edges[next++];
    }
    const int32_t at_a = column_of_edge(a), at_b = column_of_edge(b);
    const int32_t left = HWY_MAX(HWY_MIN(at_a, at_b), 0);
    const int32_t right = HWY_MIN(HWY_MAX(at_a, at_b), target.width_px);
    if (left < right) {
      auto* const out = reinterpret_cast<int32_t*>(target.pixels.data()) +
                        ptrdiff_t{row} * target.pitch_px + left;
      spans.draw({row, left, right - left}, texels, out);
    }
    a.x_fx32 += a.step_fx32;
    b.x_fx32 += b.step_fx32;
  }
}

template <class Fetch>
void draw_polygon(const InexactPolygon& polygon, const Texture& texture, Target& target) {
  if (polygon.affine) return draw_rows<Affine<Fetch>>(polygon, texture, target);
  draw_rows<Projective<Fetch>>(polygon, texture, target);
}

template <int32_t kRows>
void draw_in_window(int32_t rows, const InexactPolygon& polygon, const Texture& texture,
                    Target& target) {
  if constexpr (kRows > Windows::kRowsAPermute) {
    if (rows < kRows)
      return draw_in_window<kRows - Windows::kRowsAPermute>(rows, polygon, texture, target);
  }
  draw_polygon<OneWindow<kRows>>(polygon, texture, target);
}

// By one window where all texels of the polygon are in one, by one a vector elsewhere.
void draw_by_windows(const InexactPolygon& polygon, const Texture& texture, Target& target) {
  const auto count = [](const TexelRange& range) { return range.last - range.first + 1; };
  const int32_t rows =
      Windows::rows_for(count(polygon.columns), count(polygon.rows), texture.side_texel);
  if (rows == 0) return draw_polygon<Windows>(polygon, texture, target);
  draw_in_window<Windows::kMostRows>(rows, polygon, texture, target);
}

}  // namespace
}  // namespace selvage::reports::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
