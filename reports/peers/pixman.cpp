// pixman: each polygon rasterised into a mask of one bit a pixel, the texture composited through it.
#include <pixman.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "reports/bench/planes.h"
#include "reports/peers/peer.h"

namespace selvage::reports {

namespace {

using Polygon = std::vector<selvage_vertex>;
using Image = std::shared_ptr<pixman_image_t>;

Image owned(pixman_image_t* image) {
  if (image == nullptr) throw std::runtime_error("pixman: no memory for an image");
  return {image, pixman_image_unref};
}

Image image_over(pixman_format_code_t format, const uint32_t* pixels, int32_t width, int32_t height,
                 int32_t pitch) {
  // pixman only reads its sources; it has no constant view.
  return owned(pixman_image_create_bits(format, width, height, const_cast<uint32_t*>(pixels),
                                        pitch * 4));
}

pixman_point_fixed_t point_of(const selvage_vertex& vertex) {
  return {vertex.x * 256, vertex.y * 256};  // 1/65536 px
}

pixman_transform_t to_texture(const Polygon& polygon) {
  const Planes p = planes_of(polygon);
  const pixman_f_transform_t exact = {{{p.u.dx, p.u.dy, p.u.origin},
                                       {p.v.dx, p.v.dy, p.v.origin},
                                       {p.q.dx, p.q.dy, p.q.origin}}};
  pixman_transform_t rounded;
  if (!pixman_transform_from_pixman_f_transform(&rounded, &exact))
    throw std::runtime_error("pixman: a map has elements beyond its 16.16");
  return rounded;
}

pixman_box32_t bounds_of(const Polygon& polygon, int32_t w, int32_t h) {
  pixman_box32_t box{w, h, 0, 0};
  for (const selvage_vertex& vertex : polygon) {
    const int32_t x = vertex.x >> 8, y = vertex.y >> 8;
    box.x1 = std::min(box.x1, x), box.x2 = std::max(box.x2, x + 1);
    box.y1 = std::min(box.y1, y), box.y2 = std::max(box.y2, y + 1);
  }
  return {std::max(box.x1, 0), std::max(box.y1, 0), std::min(box.x2, w), std::min(box.y2, h)};
}

void add_polygon(pixman_image_t* mask, const Polygon& polygon) {
  for (size_t i = 1; i + 1 < polygon.size(); ++i) {
    const pixman_triangle_t triangle{point_of(polygon[0]), point_of(polygon[i]),
                                     point_of(polygon[i + 1])};
    pixman_add_triangles(mask, 0, 0, 1, &triangle);
  }
}

std::function<void()> prepare(const Workload& load, const Texture& texture, Target& target) {
  const char* mode = getenv("PIXMAN_MODE");
  const int m = mode ? atoi(mode) : 0;
  const auto sf = m == 1 || m == 4 ? PIXMAN_a8r8g8b8 : PIXMAN_x8r8g8b8;
  const Image source = image_over(sf, texture.texels.data(), texture.side_texel,
                                  texture.side_texel, texture.pitch_texel);
  const Image drawn = image_over(sf, target.pixels.data(), target.width_px, target.height_px,
                                 target.width_px);
  const Image mask = owned(
      pixman_image_create_bits(m == 3 ? PIXMAN_a8 : PIXMAN_a1, target.width_px, target.height_px, nullptr, 0));
  pixman_image_set_filter(source.get(),
                          load.filter == kBilinear ? PIXMAN_FILTER_BILINEAR : PIXMAN_FILTER_NEAREST,
                          nullptr, 0);
  pixman_image_set_repeat(source.get(), m == 2 || m==4 ? PIXMAN_REPEAT_NONE : PIXMAN_REPEAT_PAD);
  return [&load, &target, source, drawn, mask, m] {
    for (const Polygon& polygon : load.polygons) {
      const pixman_transform_t map = to_texture(polygon);
      pixman_image_set_transform(source.get(), &map);
      const pixman_box32_t box = bounds_of(polygon, target.width_px, target.height_px);
      const int32_t w = box.x2 - box.x1, h = box.y2 - box.y1;
      if (m != 2 && m != 4) {
        const pixman_color_t none{0, 0, 0, 0};
        pixman_image_fill_boxes(PIXMAN_OP_SRC, mask.get(), &none, 1, &box);
        add_polygon(mask.get(), polygon);
      }
      if (m == 0 || m == 3) {
        pixman_image_composite32(PIXMAN_OP_OVER, source.get(), mask.get(), drawn.get(), box.x1,
                                 box.y1, box.x1, box.y1, box.x1, box.y1, w, h);
      } else if (m == 1) {
        pixman_region32_t region;
        pixman_region32_init_from_image(&region, mask.get());
        pixman_image_set_clip_region32(drawn.get(), &region);
        pixman_image_composite32(PIXMAN_OP_SRC, source.get(), nullptr, drawn.get(), box.x1, box.y1,
                                 0, 0, box.x1, box.y1, w, h);
        pixman_region32_fini(&region);
      } else if (m == 2) {
        pixman_image_composite32(PIXMAN_OP_OVER, source.get(), nullptr, drawn.get(), box.x1, box.y1,
                                 0, 0, box.x1, box.y1, w, h);
      } else if (m == 4) {
        pixman_image_composite32(PIXMAN_OP_SRC, source.get(), nullptr, drawn.get(), box.x1, box.y1,
                                 0, 0, box.x1, box.y1, w, h);
      }
    }
  };
}

}  // namespace

Peer peer_pixman() {
  Subject subject;
  subject.id = "pixman";
  subject.title = std::string("pixman ") + pixman_version_string();
  subject.configuration = "as described above for now";
  subject.bilinear = true;
  subject.carried_bits = kThreeBytes;
  subject.refusal = [](const Workload&) { return std::string(); };
  subject.prepare = prepare;
  return {subject, pixman_version_string()};
}

}  // namespace selvage::reports
