// SDL2's software renderer: SDL_RenderGeometry into a surface over the target's memory.
#include <SDL.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "reports/peers/peer.h"

namespace selvage::reports {

namespace {

constexpr Uint32 kFormat = SDL_PIXELFORMAT_ARGB8888;

[[noreturn]] void fail() { throw std::runtime_error(std::string("SDL: ") + SDL_GetError()); }

template <typename T>
T* needed(T* pointer) {
  if (pointer == nullptr) fail();
  return pointer;
}

void demand(int status) {
  if (status != 0) fail();
}

// A renderer over the target, with the texture it owns.
class Screen {
 public:
  Screen(const Texture& texture, Target& target)
      : surface_(needed(SDL_CreateRGBSurfaceWithFormatFrom(target.pixels.data(), target.width_px,
                                                           target.height_px, 32,
                                                           target.width_px * 4, kFormat)),
                 SDL_FreeSurface),
        renderer_(needed(SDL_CreateSoftwareRenderer(surface_.get())), SDL_DestroyRenderer),
        texture_(needed(SDL_CreateTexture(renderer_.get(), kFormat, SDL_TEXTUREACCESS_STATIC,
                                          texture.side_texel, texture.side_texel)),
                 SDL_DestroyTexture) {
    demand(
        SDL_UpdateTexture(texture_.get(), nullptr, texture.texels.data(), texture.pitch_texel * 4));
    demand(SDL_SetTextureBlendMode(texture_.get(), SDL_BLENDMODE_NONE));
    demand(SDL_SetTextureScaleMode(texture_.get(), SDL_ScaleModeNearest));
  }

  void draw(const std::vector<SDL_Vertex>& corners) {
    demand(SDL_RenderGeometry(renderer_.get(), texture_.get(), corners.data(),
                              static_cast<int>(corners.size()), nullptr, 0));
    demand(SDL_RenderFlush(renderer_.get()));
  }

 private:
  template <typename T>
  using Owned = std::unique_ptr<T, void (*)(T*)>;
  Owned<SDL_Surface> surface_;
  Owned<SDL_Renderer> renderer_;
  Owned<SDL_Texture> texture_;
};

SDL_Vertex corner_of(const selvage_vertex& vertex, int32_t side_texel) {
  const auto number = [](double value) { return static_cast<float>(value); };
  return {{number(x_px(vertex)), number(y_px(vertex))},
          {255, 255, 255, 255},
          {number(u_texel(vertex) / side_texel), number(v_texel(vertex) / side_texel)}};
}

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

void draw(const Workload& load, Screen& screen, std::vector<SDL_Vertex>& corners) {
  corners.clear();
  for (const auto& polygon : load.polygons) {
    for (size_t i = 1; i + 1 < polygon.size(); ++i) {
      for (const size_t j : {size_t{0}, i, i + 1})
        corners.push_back(corner_of(polygon[j], load.texture_side_texel));
    }
  }
  screen.draw(corners);
}

}  // namespace

Peer peer_sdl() {
  SDL_version version;
  SDL_GetVersion(&version);
  std::string number = std::to_string(version.major);
  number.append(".").append(std::to_string(version.minor));
  number.append(".").append(std::to_string(version.patch));
  Subject subject;
  subject.id = "SDL";
  subject.title = "SDL2's software renderer";
  subject.configuration =
      "SDL_CreateSoftwareRenderer on a surface over our memory, ARGB8888 to ARGB8888, "
      "SDL_BLENDMODE_NONE, SDL_ScaleModeNearest (it knows no other for triangles), one "
      "SDL_RenderGeometry for all polygons, then SDL_RenderFlush, one thread; filling its vertices "
      "is timed; it truncates vertices to whole pixels and whole texels";
  subject.refusal = refusal;
  subject.prepare = [](const Workload& load, const Texture& texture, Target& target) {
    const auto screen = std::make_shared<Screen>(texture, target);
    return [&load, screen, corners = std::vector<SDL_Vertex>()]() mutable {
      draw(load, *screen, corners);
    };
  };
  return {subject, number.append(", ").append(SDL_GetRevision())};
}

}  // namespace selvage::reports
