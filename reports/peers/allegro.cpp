// Allegro 4's software polygons: affine or perspective texture mapping into a memory bitmap whose
// rows are pointed at the target's.
#define ALLEGRO_NO_MAGIC_MAIN
#include <allegro.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <stdexcept>

#include "reports/peers/peer.h"

namespace selvage::reports {

namespace {

constexpr int kBits = 32;

using Bitmap = std::shared_ptr<BITMAP>;

Bitmap make_bitmap(int32_t width_px, int32_t height_px) {
  BITMAP* bitmap = create_bitmap_ex(kBits, width_px, height_px);
  if (bitmap == nullptr) throw std::runtime_error("Allegro: no memory for a bitmap");
  return {bitmap, destroy_bitmap};
}

Bitmap bitmap_over(const Canvas& canvas) {
  const selvage_image& target = canvas.target;
  Bitmap bitmap = make_bitmap(target.width, target.height);
  for (int32_t y = 0; y < target.height; ++y)
    bitmap->line[y] = static_cast<unsigned char*>(target.pixels) + y * target.pitch;
  if (canvas.clip) {
    const selvage_rect& clip = *canvas.clip;
    set_clip_rect(bitmap.get(), clip.left, clip.top, clip.right - 1, clip.bottom - 1);
  }
  return bitmap;
}

bool is_power_of_two(int32_t side) { return (side & (side - 1)) == 0; }

// Allegro's texture has no row padding.
Bitmap bitmap_of(const selvage_texture& texture) {
  if (!is_power_of_two(texture.width) || !is_power_of_two(texture.height))
    throw Inexpressible("the sides of Allegro's textures are powers of two");
  Bitmap bitmap = make_bitmap(texture.width, texture.height);
  for (int32_t t = 0; t < texture.height; ++t) {
    const auto* row = static_cast<const unsigned char*>(texture.texels) + t * texture.pitch;
    std::copy(row, row + ptrdiff_t{texture.width} * (kBits / 8), bitmap->line[t]);
  }
  return bitmap;
}

// Allegro samples at whole coordinates: half a pixel less puts its samples on the pixels' centres.
V3D_f corner_of(const selvage_vertex& vertex, int32_t first_q) {
  const auto number = [](double value) { return static_cast<float>(value); };
  return {number(x_px(vertex) - 0.5),
          number(y_px(vertex) - 0.5),
          number(static_cast<double>(first_q) / vertex.q),
          number(u_texel(vertex)),
          number(v_texel(vertex)),
          0};
}

class AllegroPainter : public Painter {
 public:
  explicit AllegroPainter(const Canvas& canvas)
      : kind_(canvas.perspective ? POLYTYPE_PTEX : POLYTYPE_ATEX),
        texture_(bitmap_of(canvas.texture)),
        target_(bitmap_over(canvas)) {}

  void draw(std::span<const Polygon> polygons) override {
    for (const Polygon& polygon : polygons) draw(polygon);
  }

 private:
  void draw(const Polygon& polygon) {
    corners_.clear();
    for (const selvage_vertex& vertex : polygon)
      corners_.push_back(corner_of(vertex, polygon.front().q));
    pointers_.clear();
    for (V3D_f& corner : corners_) pointers_.push_back(&corner);
    if (corners_.size() == 3)
      triangle3d_f(target_.get(), kind_, texture_.get(), pointers_[0], pointers_[1], pointers_[2]);
    else
      polygon3d_f(target_.get(), kind_, texture_.get(), static_cast<int>(pointers_.size()),
                  pointers_.data());
  }

  int kind_;
  Bitmap texture_, target_;
  std::vector<V3D_f> corners_;
  std::vector<V3D_f*> pointers_;
};

void demand_allegro() {
  static const int status = install_allegro(SYSTEM_NONE, &errno, nullptr);
  if (status != 0) throw std::runtime_error(std::string("Allegro: ") + allegro_error);
}

}  // namespace

std::unique_ptr<Painter> paint_with_allegro(const Canvas& canvas) {
  demand_allegro();
  return std::make_unique<AllegroPainter>(canvas);
}

Peer peer_allegro() {
  demand_allegro();
  Subject subject;
  subject.id = "Allegro";
  subject.title = "Allegro " ALLEGRO_VERSION_STR " software polygons";
  subject.configuration =
      "POLYTYPE_ATEX, in perspective POLYTYPE_PTEX (which divides at every fourth pixel), on "
      "memory "
      "bitmaps of 32 bits, triangle3d_f or polygon3d_f once a polygon, one thread; vertices less "
      "half a pixel, for it samples at whole coordinates; bitmaps are made beforehand";
  subject.refusal = [](const Workload&) { return std::string(); };
  subject.prepare = prepared_by(paint_with_allegro);
  return {subject, allegro_id};
}

}  // namespace selvage::reports
