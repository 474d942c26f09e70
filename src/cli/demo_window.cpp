#include "cli/demo_window.h"

#include <SDL.h>

#include <optional>
#include <string_view>

#include "cli/error.h"

namespace selvage::cli {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw UserError(what + ": " + SDL_GetError() +
                  ". The demo needs a window system: run it where DISPLAY or WAYLAND_DISPLAY is "
                  "set, or draw without one: selvage render");
}

// Those that a key held down repeats.
[[nodiscard]] std::optional<DemoKey> moving_key(SDL_Keycode key) {
  switch (key) {
    case SDLK_LEFT:
      return DemoKey::kLeft;
    case SDLK_RIGHT:
      return DemoKey::kRight;
    case SDLK_UP:
      return DemoKey::kUp;
    case SDLK_DOWN:
      return DemoKey::kDown;
    case SDLK_PLUS:
    case SDLK_EQUALS:  // where + is above =
    case SDLK_KP_PLUS:
      return DemoKey::kNearer;
    case SDLK_MINUS:
    case SDLK_KP_MINUS:
      return DemoKey::kFarther;
    default:
      return std::nullopt;
  }
}

[[nodiscard]] std::optional<DemoKey> single_key(SDL_Keycode key, bool shift) {
  switch (key) {
    case SDLK_s:
      return shift ? DemoKey::kSlower : DemoKey::kFaster;
    case SDLK_x:
      return DemoKey::kAxisX;
    case SDLK_y:
      return DemoKey::kAxisY;
    case SDLK_z:
      return DemoKey::kAxisZ;
    case SDLK_SPACE:
      return DemoKey::kFlipAxis;
    case SDLK_f:
      return DemoKey::kFilter;
    case SDLK_m:
      return DemoKey::kMapper;
    case SDLK_d:
      return DemoKey::kDifference;
    case SDLK_p:
      return DemoKey::kReport;
    case SDLK_h:
      return DemoKey::kHelp;
    case SDLK_ESCAPE:
    case SDLK_q:
      return DemoKey::kQuit;
    default:
      return std::nullopt;
  }
}

[[nodiscard]] std::optional<DemoKey> key_of(const SDL_Event& event) {
  if (event.type == SDL_QUIT) return DemoKey::kQuit;
  if (event.type != SDL_KEYDOWN) return std::nullopt;
  const SDL_Keysym& pressed = event.key.keysym;
  if ((pressed.mod & (KMOD_CTRL | KMOD_ALT | KMOD_GUI)) != 0) return std::nullopt;
  if (const auto key = moving_key(pressed.sym)) return key;
  if (event.key.repeat != 0) return std::nullopt;
  return single_key(pressed.sym, (pressed.mod & KMOD_SHIFT) != 0);
}

// SDL falls back to drivers without a screen. Who asks for one by name gets it.
[[nodiscard]] bool shows_nothing() {
  const std::string_view driver = SDL_GetCurrentVideoDriver();
  return SDL_getenv("SDL_VIDEODRIVER") == nullptr &&
         (driver == "offscreen" || driver == "dummy" || driver == "evdev");
}

}  // namespace

struct DemoWindow::Handles {
  struct Video {
    Video() {
      SDL_SetMainReady();
      SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");  // Ctrl-C ends the program, as everywhere
      if (SDL_Init(SDL_INIT_VIDEO) != 0) fail("no window can be opened");
      if (shows_nothing()) {
        SDL_Quit();
        SDL_SetError("no window system answers");
        fail("no window can be opened");
      }
    }
    ~Video() { SDL_Quit(); }
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;
  };

  Video video;
  std::unique_ptr<SDL_Window, void (*)(SDL_Window*)> window{nullptr, SDL_DestroyWindow};
};

DemoWindow::DemoWindow(const std::string& title, scene::Size size)
    : handles_(std::make_unique<Handles>()) {
  handles_->window.reset(SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED,
                                          SDL_WINDOWPOS_CENTERED, size.width_px, size.height_px,
                                          SDL_WINDOW_RESIZABLE | SDL_WINDOW_HIDDEN));
  // The first surface may make the window anew, which would lose keys pressed until then.
  if (!handles_->window || SDL_GetWindowSurface(handles_->window.get()) == nullptr) {
    fail("no window can be opened");
  }
  SDL_ShowWindow(handles_->window.get());
}

DemoWindow::~DemoWindow() = default;

scene::Size DemoWindow::size() const {
  scene::Size size;
  SDL_GetWindowSize(handles_->window.get(), &size.width_px, &size.height_px);
  return size;
}

std::vector<DemoKey> DemoWindow::keys() {
  std::vector<DemoKey> pressed;
  SDL_Event event;
  while (SDL_PollEvent(&event) != 0) {
    if (const auto key = key_of(event)) pressed.push_back(*key);
  }
  return pressed;
}

void DemoWindow::show(Raster& picture) {
  const std::unique_ptr<SDL_Surface, void (*)(SDL_Surface*)> source(
      SDL_CreateRGBSurfaceWithFormatFrom(picture.rgba.data(), picture.width_px, picture.height_px,
                                         32, picture.width_px * 4, SDL_PIXELFORMAT_RGBA32),
      SDL_FreeSurface);
  SDL_Surface* target = SDL_GetWindowSurface(handles_->window.get());
  if (!source || target == nullptr) fail("the window cannot be drawn in");
  SDL_SetSurfaceBlendMode(source.get(), SDL_BLENDMODE_NONE);
  if (SDL_BlitSurface(source.get(), nullptr, target, nullptr) != 0 ||
      SDL_UpdateWindowSurface(handles_->window.get()) != 0) {
    fail("the window cannot be drawn in");
  }
}

void DemoWindow::rest_ms(int64_t time_ms) {
  if (time_ms > 0) SDL_Delay(static_cast<Uint32>(time_ms));
}

}  // namespace selvage::cli
