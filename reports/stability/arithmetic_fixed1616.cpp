// 16.16 fixed point, affine: x, u and v in 1/65536 px and texel, stepped by additions down the two
// sides and along the span.
//
//   slopes     dx/dy, du/dy, dv/dy of an edge and du/dx, dv/dx of a span, each one division rounded
//              down to 1/65536: after n steps a coordinate is up to n/65536 too small
//   prestep    from a vertex to its first row's centre and from the edge to the span's first
//   pixel's
//              centre, rounded down
//   texel      floor: the upper half
//
// Registers have 64 bits, so that what shows is rounding and not overflow. dx, du < 2^32 over a
// height or width of at least 2^-16 px, each product with a distance within that height or width:
// all stay below 2^50.
#include "reports/stability/arithmetic.h"
#include "reports/stability/arithmetic_chain.h"

namespace selvage::stability {
namespace {

constexpr int64_t kOne_fx16 = 65536;
constexpr int64_t kFx16OfFx8 = 256;
constexpr int32_t kHalf_fx8 = SELVAGE_SUBPIXELS / 2;

[[nodiscard]] int64_t floor_div(int64_t n, int64_t d) {  // d > 0
  return n / d - (n % d < 0 ? 1 : 0);
}

class Edge {
 public:
  Edge() = default;
  Edge(const selvage_vertex& top, const selvage_vertex& bottom, int32_t y_px) {
    const int64_t height_fx8 = int64_t{bottom.y} - top.y;
    const int64_t down_fx8 = int64_t{y_px} * SELVAGE_SUBPIXELS + kHalf_fx8 - top.y;
    const auto start = [&](int64_t from_fx16, int64_t to_fx16, int64_t* slope_fx16) {
      *slope_fx16 = floor_div((to_fx16 - from_fx16) * SELVAGE_SUBPIXELS, height_fx8);
      return from_fx16 + (*slope_fx16 * down_fx8 >> 8);
    };
    x = start(top.x * kFx16OfFx8, bottom.x * kFx16OfFx8, &x_slope_);
    u = start(top.u, bottom.u, &u_slope_);
    v = start(top.v, bottom.v, &v_slope_);
  }

  void step() { x += x_slope_, u += u_slope_, v += v_slope_; }

  int64_t x = 0, u = 0, v = 0;  // at the row's centre, fx16

 private:
  int64_t x_slope_ = 0, u_slope_ = 0, v_slope_ = 0;
};

[[nodiscard]] int64_t first_centre(int64_t x_fx16) { return (x_fx16 + kOne_fx16 / 2 - 1) >> 16; }

template <class Pixels>
void draw_span(const Call& call, const Pixels& pixels, int32_t y_px, const Edge& left,
               const Edge& right) {
  const int64_t first = std::max<int64_t>(first_centre(left.x), call.visible.left);
  const int64_t end = std::min<int64_t>(first_centre(right.x), call.visible.right);
  if (first >= end) return;
  const int64_t width = right.x - left.x;  // above 0: a centre lies in it
  const int64_t prestep = first * kOne_fx16 + kOne_fx16 / 2 - left.x;
  const int64_t du = floor_div((right.u - left.u) * kOne_fx16, width);
  const int64_t dv = floor_div((right.v - left.v) * kOne_fx16, width);
  int64_t u = left.u + (du * prestep >> 16);
  int64_t v = left.v + (dv * prestep >> 16);
  char* row = pixels.row(y_px);
  for (auto x = static_cast<int32_t>(first); x < end; ++x, u += du, v += dv)
    pixels.copy(row, x, static_cast<int32_t>(u >> 16), static_cast<int32_t>(v >> 16));
}

selvage_status draw_fixed1616(const selvage_image* target, const selvage_rect* clip,
                              const selvage_vertex* vertices, size_t count,
                              const selvage_texture* texture, const selvage_options* options) {
  return draw_checked(target, clip, vertices, count, texture, options,
                      [](const Call& call, const auto& pixels) {
                        for_each_row<Edge>(call, [&](int32_t y_px, const Edge& a, const Edge& b) {
                          const bool a_is_left = a.x <= b.x;
                          draw_span(call, pixels, y_px, a_is_left ? a : b, a_is_left ? b : a);
                        });
                      });
}

}  // namespace

Arithmetic fixed1616() {
  return {"fixed1616",
          "16.16 fixed point: x, u, v stepped down the edges, u, v along the span, prestepped; "
          "slopes and presteps rounded down, floor; affine",
          true, draw_fixed1616};
}

}  // namespace selvage::stability
