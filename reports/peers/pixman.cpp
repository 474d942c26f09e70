// pixman composites images through a transform. A single polygon is rasterised by pixman into bits,
// which clip a copy of the texture; the triangles of a mesh are composited one by one.
#include <pixman.h>

#include <algorithm>
#include <cmath>
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
  return owned(
      pixman_image_create_bits(format, width, height, const_cast<uint32_t*>(pixels), pitch * 4));
}

// The matrix is of 16.16 numbers, and so are the products u q, v q and q that a pixel divides: the
// scale of a projective matrix, which is free, is the largest at which they still fit.
double scale_of(const Planes& planes, const Polygon& polygon) {
  double largest = 1;
  for (const selvage_vertex& vertex : polygon) {
    for (const Plane* plane : {&planes.u, &planes.v, &planes.q})
      largest = std::max(largest, std::abs(plane->at(x_px(vertex), y_px(vertex))));
  }
  for (const Plane* plane : {&planes.u, &planes.v, &planes.q})
    largest = std::max(largest, std::abs(plane->origin));
  return 16384 / largest;
}

void set_map(pixman_image_t* source, const Polygon& polygon) {
  const Planes p = planes_of(polygon);
  pixman_f_transform_t exact = {
      {{p.u.dx, p.u.dy, p.u.origin}, {p.v.dx, p.v.dy, p.v.origin}, {p.q.dx, p.q.dy, p.q.origin}}};
  if (!p.affine) {
    const double scale = scale_of(p, polygon);
    for (auto& row : exact.m) {
      for (double& element : row) element *= scale;
    }
  }
  pixman_transform_t rounded;
  if (pixman_transform_from_pixman_f_transform(&rounded, &exact) == 0 ||
      pixman_image_set_transform(source, &rounded) == 0)
    throw std::runtime_error("pixman: the map is beyond its 16.16");
}

std::vector<pixman_triangle_t> triangles_of(const Polygon& polygon) {
  const auto point = [](const selvage_vertex& vertex) {
    return pixman_point_fixed_t{vertex.x * 256, vertex.y * 256};  // 16.16
  };
  std::vector<pixman_triangle_t> triangles;
  for (size_t i = 1; i + 1 < polygon.size(); ++i)
    triangles.push_back({point(polygon[0]), point(polygon[i]), point(polygon[i + 1])});
  return triangles;
}

struct Images {
  Image texture, target, bits;
};

void draw_clipped(const Images& images, const Polygon& polygon) {
  const int32_t width = pixman_image_get_width(images.target.get());
  const int32_t height = pixman_image_get_height(images.target.get());
  const pixman_color_t none{};
  const pixman_box32_t all{0, 0, width, height};
  pixman_image_fill_boxes(PIXMAN_OP_SRC, images.bits.get(), &none, 1, &all);
  const auto triangles = triangles_of(polygon);
  pixman_add_triangles(images.bits.get(), 0, 0, static_cast<int>(triangles.size()),
                       triangles.data());
  pixman_region32_t covered;
  pixman_region32_init_from_image(&covered, images.bits.get());
  pixman_image_set_clip_region32(images.target.get(), &covered);
  set_map(images.texture.get(), polygon);
  pixman_image_composite32(PIXMAN_OP_SRC, images.texture.get(), nullptr, images.target.get(), 0, 0,
                           0, 0, 0, 0, width, height);
  pixman_image_set_clip_region32(images.target.get(), nullptr);
  pixman_region32_fini(&covered);
}

void draw_triangle(const Images& images, const Polygon& polygon) {
  set_map(images.texture.get(), polygon);
  const auto triangles = triangles_of(polygon);
  pixman_composite_triangles(PIXMAN_OP_OVER, images.texture.get(), images.target.get(), PIXMAN_a1,
                             0, 0, 0, 0, static_cast<int>(triangles.size()), triangles.data());
}

std::function<void()> prepare(const Workload& load, const Texture& texture, Target& target) {
  Images images;
  images.texture = image_over(PIXMAN_x8r8g8b8, texture.texels.data(), texture.side_texel,
                              texture.side_texel, texture.pitch_texel);
  images.target = image_over(PIXMAN_x8r8g8b8, target.pixels.data(), target.width_px,
                             target.height_px, target.width_px);
  images.bits =
      owned(pixman_image_create_bits(PIXMAN_a1, target.width_px, target.height_px, nullptr, 0));
  const auto filter = load.filter == kBilinear ? PIXMAN_FILTER_BILINEAR : PIXMAN_FILTER_NEAREST;
  pixman_image_set_filter(images.texture.get(), filter, nullptr, 0);
  pixman_image_set_repeat(images.texture.get(), PIXMAN_REPEAT_PAD);
  const auto draw = load.polygons.size() == 1 ? draw_clipped : draw_triangle;
  return [&load, images, draw] {
    for (const Polygon& polygon : load.polygons) draw(images, polygon);
  };
}

}  // namespace

Peer peer_pixman() {
  Subject subject;
  subject.id = "pixman";
  subject.title = "pixman " PIXMAN_VERSION_STRING;
  subject.configuration =
      "x8r8g8b8 (24 of 32 bits survive) to x8r8g8b8, PIXMAN_FILTER_NEAREST (W5: "
      "PIXMAN_FILTER_BILINEAR), PIXMAN_REPEAT_PAD, one "
      "thread; a single polygon: pixman_add_triangles into an a1 image, its "
      "pixman_region32_init_from_image as the target's clip, PIXMAN_OP_SRC; a mesh: "
      "pixman_composite_triangles, PIXMAN_OP_OVER through an a1 mask, a call a triangle; the "
      "matrix from the vertices is timed; images are made beforehand";
  subject.bilinear = true;
  subject.carried_bits = kThreeBytes;
  subject.refusal = [](const Workload&) { return std::string(); };
  subject.prepare = prepare;
  return {subject, pixman_version_string()};
}

}  // namespace selvage::reports
