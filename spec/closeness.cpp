#include "spec/closeness.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "spec/model.h"
#include "spec/profiles.h"
#include "spec/vertex_units.h"

namespace selvage::spec {
namespace {

constexpr int32_t kEasyShare = 4;
constexpr double kWholeStep = 1.0 / (1 << 20);  // of 1/65536: what double may be off a whole one

// The places of one kind that are nearest so far.
class Nearest {
 public:
  void add(double distance, bool easy) {
    const int32_t places = distance > 0 ? -std::ilogb(distance) : kTieBits + 1;
    const int32_t bits = places > kTieBits ? kOfATie : std::min(places, kMostBits);
    const int32_t counted = bits * bits / kMostBits;
    bits_.push_back(easy ? counted / kEasyShare : counted);
  }
  [[nodiscard]] int32_t sum() {
    const size_t count = std::min(bits_.size(), size_t{kPlaces});
    std::partial_sort(bits_.begin(), bits_.begin() + static_cast<std::ptrdiff_t>(count),
                      bits_.end(), std::greater());
    int32_t total = 0;
    for (size_t i = 0; i < count; ++i) total += bits_[i];
    return total;
  }

 private:
  std::vector<int32_t> bits_;
};

[[nodiscard]] double to_whole(double value) { return std::abs(value - std::nearbyint(value)); }

struct End {
  double x_fx8, u_q, v_q, q;
};

// How a sample's u or v becomes a step: it is that of floor(scale * texels + offset).
struct Steps {
  double scale, offset;
};
[[nodiscard]] Steps steps_of(const Case& c) {
  if (c.filter == SELVAGE_FILTER_NEAREST) {
    return {1, static_cast<double>(profile_of(c).rounding_fx16) / kTexel_fx16};
  }
  return c.filter == SELVAGE_FILTER_FOUR ? Steps{1, 0.5} : Steps{256, 0};
}

// What of the target the clip leaves.
[[nodiscard]] selvage_rect seen_of(const Case& c) {
  const selvage_rect whole{0, 0, c.target_width_px, c.target_height_px};
  if (!c.has_clip) return whole;
  return {std::max(c.clip.left, whole.left), std::max(c.clip.top, whole.top),
          std::min(c.clip.right, whole.right), std::min(c.clip.bottom, whole.bottom)};
}

// The places of a case, row by row.
class Places {
 public:
  explicit Places(const Case& c)
      : case_(c), seen_(seen_of(c)), steps_(steps_of(c)), sample_fx8_(profile_of(c).sample_fx8) {}

  void look_at_row(int32_t y_px) {
    const int64_t y_fx8 = int64_t{y_px} * SELVAGE_SUBPIXELS + sample_fx8_;
    std::vector<End> ends;
    for (size_t i = 0; i < case_.vertices.size(); ++i) {
      const selvage_vertex* top = &case_.vertices[i];
      const selvage_vertex* bottom = &case_.vertices[(i + 1) % case_.vertices.size()];
      look_at_height(case_.vertices[i], y_fx8);
      if (top->y > bottom->y) std::swap(top, bottom);
      if (top->y <= y_fx8 && y_fx8 < bottom->y) ends.push_back(cross(*top, *bottom, y_fx8));
    }
    if (ends.size() != 2) return;
    if (ends[1].x_fx8 < ends[0].x_fx8) std::swap(ends[0], ends[1]);
    look_along(ends[0], ends[1]);
  }

  [[nodiscard]] Closeness closeness() { return {edges_.sum(), texels_.sum()}; }

 private:
  // A vertex on a row of sample points decides whether the row is crossed.
  void look_at_height(const selvage_vertex& v, int64_t y_fx8) {
    const int64_t off_fx8 = std::abs(v.y - y_fx8);
    if (off_fx8 <= 1) edges_.add(static_cast<double>(off_fx8) / kPixel_fx8, false);
  }

  // The distance of the crossing to a sample point is exact: numerators stay below 2^53.
  [[nodiscard]] End cross(const selvage_vertex& top, const selvage_vertex& bottom, int64_t y_fx8) {
    const int64_t rows = int64_t{bottom.y} - top.y, down = y_fx8 - top.y;
    const int64_t dx = int64_t{bottom.x} - top.x;
    const int64_t grid = SELVAGE_SUBPIXELS * rows;
    const int64_t at = (int64_t{top.x} - sample_fx8_) * rows + dx * down;
    const int64_t past = ((at % grid) + grid) % grid;
    const double x_fx8 = static_cast<double>(at) / static_cast<double>(rows) + sample_fx8_;
    const bool is_seen =
        x_fx8 > (seen_.left - 1) * kPixel_fx8 && x_fx8 < (seen_.right + 1) * kPixel_fx8;
    if (is_seen) {
      edges_.add(static_cast<double>(std::min(past, grid - past)) / static_cast<double>(grid),
                 dx * SELVAGE_SUBTEXELS % rows == 0);
    }
    const double t = static_cast<double>(down) / static_cast<double>(rows);
    const auto mix = [&](double a, double b) { return a + t * (b - a); };
    const double q0 = top.q, q1 = bottom.q;
    return {x_fx8, mix(top.u * q0, bottom.u * q1), mix(top.v * q0, bottom.v * q1), mix(q0, q1)};
  }

  void look_along(const End& left, const End& right) {
    const double width_fx8 = right.x_fx8 - left.x_fx8;
    if (width_fx8 <= 0) return;
    const auto column = [&](double x_fx8) {
      const double px = std::ceil((x_fx8 - sample_fx8_) / kPixel_fx8);
      return static_cast<int32_t>(std::clamp(px, 0.0, double{65536}));
    };
    const int32_t first_px = std::max(column(left.x_fx8), seen_.left);
    const int32_t end_px = std::min(column(right.x_fx8), seen_.right);
    const int32_t stride_px = std::max((end_px - first_px) / kMostLines, 1);
    const bool affine = left.q == right.q;
    for (const auto of : {&End::u_q, &End::v_q}) {
      const double step = (right.*of - left.*of) / left.q * kPixel_fx8 / width_fx8;
      const bool easy = affine && to_whole(step) < kWholeStep;
      for (int32_t x = first_px; x < end_px; x += stride_px) {
        const double t = (kPixel_fx8 * x + sample_fx8_ - left.x_fx8) / width_fx8;
        const double q = left.q + t * (right.q - left.q);
        const double fx16 = (left.*of + t * (right.*of - left.*of)) / q;
        texels_.add(to_whole(fx16 / kTexel_fx16 * steps_.scale + steps_.offset), easy);
      }
    }
  }

  const Case& case_;
  selvage_rect seen_;
  Steps steps_;
  int32_t sample_fx8_;
  Nearest edges_, texels_;
};

}  // namespace

Closeness closeness(const Case& c) {
  if (!is_valid(c)) return {};
  Places places(c);
  const selvage_rect seen = seen_of(c);
  if (seen.left >= seen.right) return {};
  const int32_t stride_px = std::max((seen.bottom - seen.top) / kMostLines, 1);
  for (int32_t y = seen.top; y < seen.bottom; y += stride_px) places.look_at_row(y);
  return places.closeness();
}

}  // namespace selvage::spec
