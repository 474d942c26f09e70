// SDL2's software renderer: SDL_RenderGeometry into a surface over the target's memory.
#include <SDL.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "reports/peers/peer.h"

namespace selvage::reports {

namespace {

constexpr Uint32 kFormat = SDL_PIXELFORMAT_ARGB8888;

[[noreturn]] void fail() { throw Inexpressible(std::string("SDL: ") + SDL_GetError()); }

template <typename T>
T* needed(T* pointer) {
  if (pointer == nullptr) fail();
  return pointer;
}

void demand(int status) {
  if (status != 0) fail();
}

SDL_Vertex corner_of(const selvage_vertex& vertex, const selvage_texture& texture) {
  const auto number = [](double value) { return static_cast<float>(value); };
  return {{number(x_px(vertex)), number(y_px(vertex))},
          {255, 255, 255, 255},
          {number(u_texel(vertex) / texture.width), number(v_texel(vertex) / texture.height)}};
}

// A renderer over the target, with the texture it owns.
class SdlPainter : public Painter {
 public:
  explicit SdlPainter(const Canvas& canvas)
      : view_(canvas.texture),
        surface_(needed(SDL_CreateRGBSurfaceWithFormatFrom(
                     canvas.target.pixels, canvas.target.width, canvas.target.height, 32,
                     static_cast<int>(canvas.target.pitch), kFormat)),
                 SDL_FreeSurface),
        renderer_(needed(SDL_CreateSoftwareRenderer(surface_.get())), SDL_DestroyRenderer),
        texture_(needed(SDL_CreateTexture(renderer_.get(), kFormat, SDL_TEXTUREACCESS_STATIC,
                                          view_.width, view_.height)),
                 SDL_DestroyTexture) {
    demand(SDL_UpdateTexture(texture_.get(), nullptr, view_.texels, static_cast<int>(view_.pitch)));
    demand(SDL_SetTextureBlendMode(texture_.get(), SDL_BLENDMODE_NONE));
    demand(SDL_SetTextureScaleMode(texture_.get(), SDL_ScaleModeNearest));
    if (!canvas.clip) return;
    const selvage_rect& clip = *canvas.clip;
    const SDL_Rect rect{clip.left, clip.top, width_of(clip), height_of(clip)};
    demand(SDL_RenderSetClipRect(renderer_.get(), &rect));
  }

  void draw(std::span<const Polygon> polygons) override {
    corners_.clear();
    for (const Polygon& polygon : polygons) {
      for (size_t i = 1; i + 1 < polygon.size(); ++i) {
        for (const size_t j : {size_t{0}, i, i + 1})
          corners_.push_back(corner_of(polygon[j], view_));
      }
    }
    demand(SDL_RenderGeometry(renderer_.get(), texture_.get(), corners_.data(),
                              static_cast<int>(corners_.size()), nullptr, 0));
    demand(SDL_RenderFlush(renderer_.get()));
  }

 private:
  template <typename T>
  using Owned = std::unique_ptr<T, void (*)(T*)>;
  const selvage_texture view_;
  Owned<SDL_Surface> surface_;
  Owned<SDL_Renderer> renderer_;
  Owned<SDL_Texture> texture_;
  std::vector<SDL_Vertex> corners_;
};

// Its software rasteriser truncates vertices to whole pixels, works on half pixels, and multiplies
// twice the triangle's area by texture coordinates in 32 bits. Beyond them SDL 2.26 reads outside
// the texture; SDL 3 refuses to draw.
bool fits_in_32_bits(const selvage_vertex& a, const selvage_vertex& b, const selvage_vertex& c,
                     int32_t side_texel) {
  constexpr double half_pixels = 2, limit = 0x80000000;
  const auto x = [](const selvage_vertex& vertex) {
    return std::trunc(x_px(vertex)) * half_pixels;
  };
  const auto y = [](const selvage_vertex& vertex) {
    return std::trunc(y_px(vertex)) * half_pixels;
  };
  const double doubled_area = (x(b) - x(a)) * (y(c) - y(a)) - (x(c) - x(a)) * (y(b) - y(a));
  return std::abs(doubled_area) * side_texel < limit;
}

bool fits_in_32_bits(const Workload& load) {
  for (const auto& polygon : load.polygons) {
    for (size_t i = 1; i + 1 < polygon.size(); ++i) {
      if (!fits_in_32_bits(polygon[0], polygon[i], polygon[i + 1], load.texture_side_texel))
        return false;
    }
  }
  return true;
}

std::string refusal(const Workload& load) {
  if (load.perspective) return "it knows no perspective";
  if (!fits_in_32_bits(load))
    return "a triangle's area times the texture's side overflows its 32 bits; it would read "
           "outside the texture";
  return "";
}

}  // namespace

std::unique_ptr<Painter> paint_with_sdl(const Canvas& canvas) {
  return std::make_unique<SdlPainter>(canvas);
}

Peer peer_sdl() {
  SDL_version version;
  SDL_GetVersion(&version);
  std::string number = std::to_string(version.major);
  number.append(".").append(std::to_string(version.minor));
  number.append(".").append(std::to_string(version.patch));
  Subject subject;
  subject.id = "SDL";
  subject.title = "SDL " + number + " software renderer";
  subject.configuration =
      "SDL_CreateSoftwareRenderer on a surface over our memory, ARGB8888 to ARGB8888, "
      "SDL_BLENDMODE_NONE, SDL_ScaleModeNearest (it knows no other for triangles), one "
      "SDL_RenderGeometry for all polygons, then SDL_RenderFlush, one thread; filling its vertices "
      "is timed; it truncates vertices to whole pixels and whole texels";
  subject.refusal = refusal;
  subject.prepare = prepared_by(paint_with_sdl);
  return {subject, number.append(", ").append(SDL_GetRevision())};
}

}  // namespace selvage::reports
