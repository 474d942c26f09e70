// Allegro 4's software polygons: affine or perspective texture mapping into a memory bitmap whose
// rows are pointed at the target's.
#define ALLEGRO_NO_MAGIC_MAIN
#include <allegro.h>

#include <algorithm>
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

V3D_f corner(const selvage_vertex& vertex, int32_t first_q) {
  const auto number = [](double value) { return static_cast<float>(value); };
  return {number(x_px(vertex)), number(y_px(vertex)), static_cast<float>(first_q) / static_cast<float>(vertex.q),
          number(u_texel(vertex)), number(v_texel(vertex)), 0};
}

void draw(BITMAP* target, BITMAP* texture, int kind, const std::vector<selvage_vertex>& polygon) {
  constexpr size_t most = 16;
  V3D_f corners[most];
  V3D_f* pointers[most];
  const size_t count = std::min(polygon.size(), most);
  for (size_t i = 0; i < count; ++i) {
    corners[i] = corner(polygon[i], polygon[0].q);
    pointers[i] = &corners[i];
  }
  if (count == 3)
    triangle3d_f(target, kind, texture, &corners[0], &corners[1], &corners[2]);
  else
    polygon3d_f(target, kind, texture, static_cast<int>(count), pointers);
}

std::function<void()> prepare(const Workload& load, const Texture& texture, Target& target) {
  const int kind = load.perspective ? POLYTYPE_PTEX : POLYTYPE_ATEX;
  return [&load, kind, source = bitmap_of(texture), drawn = bitmap_over(target)] {
    for (const auto& polygon : load.polygons) draw(drawn.get(), source.get(), kind, polygon);
  };
}

}  // namespace

Peer peer_allegro() {
  if (install_allegro(SYSTEM_NONE, &errno, nullptr) != 0)
    throw std::runtime_error(std::string("Allegro: ") + allegro_error);
  Subject subject;
  subject.id = "Allegro";
  subject.title = std::string("Allegro ") + allegro_id;
  subject.configuration = "as described above for now";
  subject.refusal = [](const Workload&) { return std::string(); };
  subject.prepare = prepare;
  return {subject, allegro_id};
}

}  // namespace selvage::reports
