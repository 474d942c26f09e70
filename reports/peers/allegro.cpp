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

Bitmap bitmap_over(Target& target) {
  Bitmap bitmap = make_bitmap(target.width_px, target.height_px);
  for (int32_t y = 0; y < target.height_px; ++y)
    bitmap->line[y] = reinterpret_cast<unsigned char*>(target.row(y));
  return bitmap;
}

// Allegro's texture has no row padding.
Bitmap bitmap_of(const Texture& texture) {
  const int32_t side = texture.side_texel;
  Bitmap bitmap = make_bitmap(side, side);
  for (int32_t t = 0; t < side; ++t) {
    const uint32_t* row = texture.texels.data() + static_cast<ptrdiff_t>(t) * texture.pitch_texel;
    std::copy(row, row + side, reinterpret_cast<uint32_t*>(bitmap->line[t]));
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

class Painter {
 public:
  Painter(const Workload& load, const Texture& texture, Target& target)
      : kind_(load.perspective ? POLYTYPE_PTEX : POLYTYPE_ATEX),
        texture_(bitmap_of(texture)),
        target_(bitmap_over(target)) {}

  void draw(const std::vector<selvage_vertex>& polygon) {
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

 private:
  int kind_;
  Bitmap texture_, target_;
  std::vector<V3D_f> corners_;
  std::vector<V3D_f*> pointers_;
};

std::function<void()> prepare(const Workload& load, const Texture& texture, Target& target) {
  return [&load, painter = std::make_shared<Painter>(load, texture, target)] {
    for (const auto& polygon : load.polygons) painter->draw(polygon);
  };
}

}  // namespace

Peer peer_allegro() {
  if (install_allegro(SYSTEM_NONE, &errno, nullptr) != 0)
    throw std::runtime_error(std::string("Allegro: ") + allegro_error);
  Subject subject;
  subject.id = "Allegro";
  subject.title = "Allegro " ALLEGRO_VERSION_STR " software polygons";
  subject.configuration =
      "POLYTYPE_ATEX, in perspective POLYTYPE_PTEX (which divides at every fourth pixel), on "
      "memory "
      "bitmaps of 32 bits, triangle3d_f or polygon3d_f once a polygon, one thread; vertices less "
      "half a pixel, for it samples at whole coordinates; bitmaps are made beforehand";
  subject.refusal = [](const Workload&) { return std::string(); };
  subject.prepare = prepare;
  return {subject, allegro_id};
}

}  // namespace selvage::reports
