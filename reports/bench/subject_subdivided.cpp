// Perspective by subdivision, as software renderers did it: a division every sixteenth pixel and a
// 16.16 loop between, on exact edges.
#include <algorithm>
#include <cmath>
#include <span>

#include "reports/bench/planes.h"
#include "reports/bench/spans.h"
#include "reports/bench/subject.h"

namespace selvage::reports {

namespace {

constexpr double kOne_fx16 = 65536;
constexpr int32_t kDivideEvery_px = 16;

uint32_t to_fx16(double texel) {
  return static_cast<uint32_t>(static_cast<int64_t>(std::floor(texel * kOne_fx16)));
}

// Texture coordinates wrap by a mask, as usual: a start that rounding moved just outside the
// texture then reads the opposite edge, never beyond the texture.
struct Sampler {
  const uint32_t* texels;
  uint32_t pitch_texel, mask;

  [[nodiscard]] uint32_t at(uint32_t u_fx16, uint32_t v_fx16) const {
    return texels[((v_fx16 >> 16) & mask) * pitch_texel + ((u_fx16 >> 16) & mask)];
  }
};

void draw_run(uint32_t* out, int32_t count_px, const Sampler& sampler, uint32_t u, uint32_t v,
              uint32_t du, uint32_t dv) {
  for (int32_t i = 0; i < count_px; ++i, u += du, v += dv) out[i] = sampler.at(u, v);
}

// u and v are exact at every sixteenth pixel and straight between.
void draw_perspective(std::span<const selvage_vertex> polygon, const Sampler& sampler,
                      Target& target) {
  const Planes planes = planes_of(polygon);
  for_each_span(polygon, target.width_px, target.height_px, [&](const Span& span) {
    const double y = span.y_px + 0.5;
    double w = 1 / planes.q.at(span.left_px + 0.5, y);
    double u = planes.u.at(span.left_px + 0.5, y) * w, v = planes.v.at(span.left_px + 0.5, y) * w;
    for (int32_t x = span.left_px; x < span.right_px; x += kDivideEvery_px) {
      const int32_t count = std::min(kDivideEvery_px, span.right_px - x);
      const double end = x + count + 0.5;
      w = 1 / planes.q.at(end, y);
      const double u_end = planes.u.at(end, y) * w, v_end = planes.v.at(end, y) * w;
      const double scale = kOne_fx16 / count;
      draw_run(target.row(span.y_px) + x, count, sampler, to_fx16(u), to_fx16(v),
               static_cast<uint32_t>(static_cast<int32_t>((u_end - u) * scale)),
               static_cast<uint32_t>(static_cast<int32_t>((v_end - v) * scale)));
      u = u_end;
      v = v_end;
    }
  });
}

}  // namespace

Subject subject_subdivided() {
  Subject subject;
  subject.id = "subdivided";
  subject.title = "16.16 loop, a division every 16th pixel";
  subject.configuration =
      "scalar, exact edges, u and v in double at every 16th pixel of a span and stepped in 16.16 "
      "between; wraps by a mask; set-up is timed";
  subject.group = "usual";
  subject.refusal = [](const Workload& load) {
    return std::string(load.perspective ? "" : "it is a way to draw perspective");
  };
  subject.prepare = [](const Workload& load, const Texture& texture, Target& target) {
    const Sampler sampler{texture.texels.data(), static_cast<uint32_t>(texture.pitch_texel),
                          static_cast<uint32_t>(texture.side_texel - 1)};
    return [&load, sampler, &target] {
      for (const auto& polygon : load.polygons) draw_perspective(polygon, sampler, target);
    };
  };
  return subject;
}

}  // namespace selvage::reports
