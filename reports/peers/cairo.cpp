// Cairo's image backend: each polygon a path filled with the texture as a pattern.
#include <cairo.h>

#include <memory>
#include <stdexcept>

#include "reports/bench/planes.h"
#include "reports/peers/peer.h"

namespace selvage::reports {

namespace {

template <typename T>
using Owned = std::shared_ptr<T>;

void demand(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("Cairo: ") + cairo_status_to_string(status));
}

Owned<cairo_surface_t> surface_over(void* pixels, int32_t width_px, int32_t height_px,
                                    int32_t pitch_px) {
  const Owned<cairo_surface_t> surface(
      cairo_image_surface_create_for_data(static_cast<unsigned char*>(pixels), CAIRO_FORMAT_ARGB32,
                                          width_px, height_px, pitch_px * 4),
      cairo_surface_destroy);
  demand(cairo_surface_status(surface.get()));
  return surface;
}

void draw(cairo_t* cairo, cairo_pattern_t* pattern, const std::vector<selvage_vertex>& polygon) {
  const Planes planes = planes_of(polygon);
  cairo_matrix_t to_texture;
  cairo_matrix_init(&to_texture, planes.u.dx, planes.v.dx, planes.u.dy, planes.v.dy,
                    planes.u.origin, planes.v.origin);
  cairo_pattern_set_matrix(pattern, &to_texture);
  cairo_set_source(cairo, pattern);
  for (const selvage_vertex& vertex : polygon) cairo_line_to(cairo, x_px(vertex), y_px(vertex));
  cairo_close_path(cairo);
  cairo_fill(cairo);
}

std::function<void()> prepare(const Workload& load, const Texture& texture, Target& target) {
  // Cairo only reads the source; it has no constant view.
  const auto source = surface_over(const_cast<uint32_t*>(texture.texels.data()), texture.side_texel,
                                   texture.side_texel, texture.pitch_texel);
  const auto drawn =
      surface_over(target.pixels.data(), target.width_px, target.height_px, target.width_px);
  const Owned<cairo_pattern_t> pattern(cairo_pattern_create_for_surface(source.get()),
                                       cairo_pattern_destroy);
  const auto filter = load.filter == kBilinear ? CAIRO_FILTER_BILINEAR : CAIRO_FILTER_NEAREST;
  cairo_pattern_set_filter(pattern.get(), filter);
  cairo_pattern_set_extend(pattern.get(), CAIRO_EXTEND_PAD);
  const Owned<cairo_t> cairo(cairo_create(drawn.get()), cairo_destroy);
  cairo_set_antialias(cairo.get(), CAIRO_ANTIALIAS_NONE);
  cairo_set_operator(cairo.get(), CAIRO_OPERATOR_SOURCE);
  return [&load, cairo, pattern, drawn] {
    for (const auto& polygon : load.polygons) draw(cairo.get(), pattern.get(), polygon);
    cairo_surface_flush(drawn.get());
    demand(cairo_status(cairo.get()));
  };
}

}  // namespace

Peer peer_cairo() {
  Subject subject;
  subject.id = "Cairo";
  subject.title = "Cairo " CAIRO_VERSION_STRING ", image backend";
  subject.configuration =
      "cairo_fill, a path and a call a polygon, CAIRO_FORMAT_ARGB32 to CAIRO_FORMAT_ARGB32, "
      "CAIRO_OPERATOR_SOURCE (a copy), CAIRO_ANTIALIAS_NONE, CAIRO_FILTER_NEAREST "
      "(W5: CAIRO_FILTER_BILINEAR), "
      "CAIRO_EXTEND_PAD, one thread; the pattern's matrix from the vertices is timed; surfaces, "
      "pattern and context are made beforehand";
  subject.bilinear = true;
  subject.refusal = [](const Workload& load) {
    return std::string(load.perspective ? "its patterns are affine" : "");
  };
  subject.prepare = prepare;
  return {subject, cairo_version_string()};
}

}  // namespace selvage::reports
