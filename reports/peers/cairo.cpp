// Cairo's image backend: each polygon a path filled with the texture as a pattern.
#include <cairo.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "reports/peers/map.h"
#include "reports/peers/peer.h"

namespace selvage::reports {

namespace {

template <typename T>
using Owned = std::shared_ptr<T>;

void demand(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw Inexpressible(std::string("Cairo: ") + cairo_status_to_string(status));
}

Owned<cairo_surface_t> surface_over(const void* pixels, int32_t width_px, int32_t height_px,
                                    ptrdiff_t pitch_bytes) {
  // Cairo only reads its sources; it has no constant view.
  auto* bytes = static_cast<unsigned char*>(const_cast<void*>(pixels));
  const Owned<cairo_surface_t> surface(
      cairo_image_surface_create_for_data(bytes, CAIRO_FORMAT_ARGB32, width_px, height_px,
                                          static_cast<int>(pitch_bytes)),
      cairo_surface_destroy);
  demand(cairo_surface_status(surface.get()));
  return surface;
}

// Copies `height` rows.
void copy_rows(unsigned char* to, ptrdiff_t to_pitch, const void* from, ptrdiff_t from_pitch,
               size_t row_bytes, int32_t height) {
  for (int32_t y = 0; y < height; ++y)
    std::memcpy(to + y * to_pitch, static_cast<const char*>(from) + y * from_pitch, row_bytes);
}

size_t row_bytes_of(int32_t width_px) { return static_cast<size_t>(width_px) * 2; }

// RGB565 in memory of Cairo's own, whose rows begin at multiples of four bytes.
Owned<cairo_surface_t> copy_of(const void* pixels, int32_t width_px, int32_t height_px,
                               ptrdiff_t pitch_bytes) {
  const Owned<cairo_surface_t> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB16_565, width_px, height_px),
      cairo_surface_destroy);
  demand(cairo_surface_status(surface.get()));
  cairo_surface_flush(surface.get());
  copy_rows(cairo_image_surface_get_data(surface.get()),
            cairo_image_surface_get_stride(surface.get()), pixels, pitch_bytes,
            row_bytes_of(width_px), height_px);
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

Owned<cairo_surface_t> surface_for(selvage_format format, const void* pixels, int32_t width_px,
                                   int32_t height_px, ptrdiff_t pitch_bytes) {
  return format == SELVAGE_RGB565 ? copy_of(pixels, width_px, height_px, pitch_bytes)
                                  : surface_over(pixels, width_px, height_px, pitch_bytes);
}

Owned<cairo_pattern_t> pattern_of(const Canvas& canvas) {
  const selvage_texture& texture = canvas.texture;
  const auto source =
      surface_for(texture.format, texture.texels, texture.width, texture.height, texture.pitch);
  const Owned<cairo_pattern_t> pattern(cairo_pattern_create_for_surface(source.get()),
                                       cairo_pattern_destroy);
  const bool bilinear = canvas.filter == SELVAGE_FILTER_BILINEAR;
  const bool wraps = canvas.address == SELVAGE_ADDRESS_WRAP;
  cairo_pattern_set_filter(pattern.get(), bilinear ? CAIRO_FILTER_BILINEAR : CAIRO_FILTER_NEAREST);
  cairo_pattern_set_extend(pattern.get(), wraps ? CAIRO_EXTEND_REPEAT : CAIRO_EXTEND_PAD);
  return pattern;
}

class CairoPainter : public Painter {
 public:
  explicit CairoPainter(const Canvas& canvas)
      : target_(canvas.target),
        surface_(surface_for(target_.format, target_.pixels, target_.width, target_.height,
                             target_.pitch)),
        pattern_(pattern_of(canvas)),
        cairo_(cairo_create(surface_.get()), cairo_destroy) {
    cairo_set_antialias(cairo_.get(), CAIRO_ANTIALIAS_NONE);
    cairo_set_operator(cairo_.get(), CAIRO_OPERATOR_SOURCE);
    if (!canvas.clip) return;
    const selvage_rect& clip = *canvas.clip;
    cairo_rectangle(cairo_.get(), clip.left, clip.top, width_of(clip), height_of(clip));
    cairo_clip(cairo_.get());
  }

  void draw(std::span<const Polygon> polygons) override {
    for (const Polygon& polygon : polygons) draw(polygon);
    cairo_surface_flush(surface_.get());
    demand(cairo_status(cairo_.get()));
    if (target_.format == SELVAGE_RGB565)
      copy_rows(static_cast<unsigned char*>(target_.pixels), target_.pitch,
                cairo_image_surface_get_data(surface_.get()),
                cairo_image_surface_get_stride(surface_.get()), row_bytes_of(target_.width),
                target_.height);
  }

 private:
  void draw(const Polygon& polygon) {
    const Planes planes = map_of(polygon);
    cairo_matrix_t to_texture;
    cairo_matrix_init(&to_texture, planes.u.dx, planes.v.dx, planes.u.dy, planes.v.dy,
                      planes.u.origin, planes.v.origin);
    cairo_matrix_t inverse = to_texture;
    demand(cairo_matrix_invert(&inverse));  // the documented condition, before anything is drawn
    cairo_pattern_set_matrix(pattern_.get(), &to_texture);
    cairo_set_source(cairo_.get(), pattern_.get());
    for (const selvage_vertex& vertex : polygon)
      cairo_line_to(cairo_.get(), x_px(vertex), y_px(vertex));
    cairo_close_path(cairo_.get());
    cairo_fill(cairo_.get());
  }

  const selvage_image target_;
  Owned<cairo_surface_t> surface_;
  Owned<cairo_pattern_t> pattern_;
  Owned<cairo_t> cairo_;
};

}  // namespace

std::unique_ptr<Painter> paint_with_cairo(const Canvas& canvas) {
  return std::make_unique<CairoPainter>(canvas);
}

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
  subject.prepare = prepared_by(paint_with_cairo);
  return {subject, cairo_version_string()};
}

}  // namespace selvage::reports
