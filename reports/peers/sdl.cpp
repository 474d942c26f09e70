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
      : surface_(needed(SDL_CreateRGBSurfaceWithFormatFrom(
                     target.pixels.data(), target.width_px, target.height_px, 32,
                     target.width_px * 4, kFormat)),
                 SDL_FreeSurface),
        renderer_(needed(SDL_CreateSoftwareRenderer(surface_.get())), SDL_DestroyRenderer),
        texture_(needed(SDL_CreateTexture(renderer_.get(), kFormat, SDL_TEXTUREACCESS_STATIC,
                                          texture.side_texel, texture.side_texel)),
                 SDL_DestroyTexture) {
    demand(SDL_UpdateTexture(texture_.get(), nullptr, texture.texels.data(),
                             texture.pitch_texel * 4));
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

bool overflows(const Workload& load) {
  for (const auto& polygon : load.polygons) {
    for (size_t i = 1; i + 1 < polygon.size(); ++i) {
      const auto& a = polygon[0];
      const double area = (x_px(polygon[i]) - x_px(a)) * (y_px(polygon[i + 1]) - y_px(a)) -
                          (x_px(polygon[i + 1]) - x_px(a)) * (y_px(polygon[i]) - y_px(a));
      if (std::abs(area) * 4 * load.texture_side_texel > 2.0e9) return true;
    }
  }
  return false;
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
  const std::string number = std::to_string(version.major) + "." + std::to_string(version.minor) +
                             "." + std::to_string(version.patch);
  Subject subject;
  subject.id = "SDL";
  subject.title = "SDL " + number + " software renderer";
  subject.configuration = "as described above for now";
  subject.refusal = [](const Workload& load) {
    if (load.perspective) return std::string("it knows no perspective");
    return std::string(overflows(load) ? "overflows" : "");
  };
  subject.prepare = [](const Workload& load, const Texture& texture, Target& target) {
    const auto screen = std::make_shared<Screen>(texture, target);
    return [&load, screen, corners = std::vector<SDL_Vertex>()]() mutable {
      draw(load, *screen, corners);
    };
  };
  return {subject, number + ", " + SDL_GetRevision()};
}

}  // namespace selvage::reports
