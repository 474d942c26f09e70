// pixman composites images through a transform. A single polygon is rasterised by pixman into bits,
// which clip a copy of the texture; the triangles of a mesh are composited one by one.
#include <pixman.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "reports/peers/map.h"
#include "reports/peers/peer.h"

namespace selvage::reports {

namespace {

using Image = std::shared_ptr<pixman_image_t>;

Image owned(pixman_image_t* image) {
  if (image == nullptr) throw std::runtime_error("pixman: no memory for an image");
  return {image, pixman_image_unref};
}

Image image_over(pixman_format_code_t format, const void* pixels, int32_t width, int32_t height,
                 ptrdiff_t pitch_bytes) {
  // pixman only reads its sources; it has no constant view.
  auto* bits = static_cast<uint32_t*>(const_cast<void*>(pixels));
  return owned(
      pixman_image_create_bits(format, width, height, bits, static_cast<int>(pitch_bytes)));
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
  const Planes p = map_of(polygon);
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
    throw Inexpressible("the map is beyond the 16.16 of pixman's matrix");
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

class PixmanPainter : public Painter {
 public:
  explicit PixmanPainter(const Canvas& canvas)
      : clip_(canvas.clip),
        width_(canvas.target.width),
        height_(canvas.target.height),
        bits_(owned(pixman_image_create_bits(PIXMAN_a1, width_, height_, nullptr, 0))) {
    const selvage_texture& texture = canvas.texture;
    const auto format = canvas.opaque ? PIXMAN_x8r8g8b8 : PIXMAN_a8r8g8b8;
    texture_ = image_over(format, texture.texels, texture.width, texture.height, texture.pitch);
    target_ = image_over(format, canvas.target.pixels, width_, height_, canvas.target.pitch);
    const bool bilinear = canvas.filter == SELVAGE_FILTER_BILINEAR;
    const bool wraps = canvas.address == SELVAGE_ADDRESS_WRAP;
    pixman_image_set_filter(texture_.get(),
                            bilinear ? PIXMAN_FILTER_BILINEAR : PIXMAN_FILTER_NEAREST, nullptr, 0);
    pixman_image_set_repeat(texture_.get(), wraps ? PIXMAN_REPEAT_NORMAL : PIXMAN_REPEAT_PAD);
  }

  void draw(std::span<const Polygon> polygons) override {
    if (polygons.size() == 1) return draw_clipped(polygons.front());
    for (const Polygon& polygon : polygons) draw_triangle(polygon);
  }

 private:
  void draw_clipped(const Polygon& polygon) {
    set_map(texture_.get(), polygon);
    const pixman_color_t none{};
    const pixman_box32_t all{0, 0, width_, height_};
    pixman_image_fill_boxes(PIXMAN_OP_SRC, bits_.get(), &none, 1, &all);
    const auto triangles = triangles_of(polygon);
    pixman_add_triangles(bits_.get(), 0, 0, static_cast<int>(triangles.size()), triangles.data());
    pixman_region32_t covered;
    pixman_region32_init_from_image(&covered, bits_.get());
    if (clip_) {
      const auto side = [](int32_t px) { return static_cast<unsigned>(px); };
      pixman_region32_intersect_rect(&covered, &covered, clip_->left, clip_->top,
                                     side(width_of(*clip_)), side(height_of(*clip_)));
    }
    pixman_image_set_clip_region32(target_.get(), &covered);
    pixman_image_composite32(PIXMAN_OP_SRC, texture_.get(), nullptr, target_.get(), 0, 0, 0, 0, 0,
                             0, width_, height_);
    pixman_image_set_clip_region32(target_.get(), nullptr);
    pixman_region32_fini(&covered);
  }

  void draw_triangle(const Polygon& polygon) {
    set_map(texture_.get(), polygon);
    const auto triangles = triangles_of(polygon);
    pixman_composite_triangles(PIXMAN_OP_OVER, texture_.get(), target_.get(), PIXMAN_a1, 0, 0, 0, 0,
                               static_cast<int>(triangles.size()), triangles.data());
  }

  const std::optional<selvage_rect> clip_;
  const int32_t width_, height_;
  Image bits_, texture_, target_;
};

}  // namespace

std::unique_ptr<Painter> paint_with_pixman(const Canvas& canvas) {
  return std::make_unique<PixmanPainter>(canvas);
}

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
  subject.prepare = prepared_by(paint_with_pixman);
  return {subject, pixman_version_string()};
}

}  // namespace selvage::reports
