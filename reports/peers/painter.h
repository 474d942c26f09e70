// The one way in which each peer is asked to draw, by the benchmark and as a subject of the laws.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "selvage.h"

namespace selvage::reports {

using Polygon = std::vector<selvage_vertex>;

// What is drawn with and on; rows as selvage.h has them, and no negative pitch.
struct Canvas {
  selvage_image target{};
  selvage_texture texture{};
  selvage_filter filter = SELVAGE_FILTER_NEAREST;
  selvage_address address = SELVAGE_ADDRESS_CLAMP;
  std::optional<selvage_rect> clip{};  // within the target, may be empty
  bool perspective = false;            // some polygon has q that differ
  bool opaque = true;                  // the fourth byte of a pixel may get lost
};

class Painter {
 public:
  Painter() = default;
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;
  virtual ~Painter() = default;

  // Draws them in order. What is drawn is in the target when it returns. Throws Inexpressible.
  virtual void draw(std::span<const Polygon> polygons) = 0;
};

// The peer has documented limits and what is asked for lies beyond them, or it answers by an error
// of its own.
class Inexpressible : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

using MakePainter = std::unique_ptr<Painter> (*)(const Canvas&);

[[nodiscard]] std::unique_ptr<Painter> paint_with_agg(const Canvas& canvas);
[[nodiscard]] std::unique_ptr<Painter> paint_with_allegro(const Canvas& canvas);
[[nodiscard]] std::unique_ptr<Painter> paint_with_cairo(const Canvas& canvas);
[[nodiscard]] std::unique_ptr<Painter> paint_with_llvmpipe(const Canvas& canvas);
[[nodiscard]] std::unique_ptr<Painter> paint_with_opencv(const Canvas& canvas);
[[nodiscard]] std::unique_ptr<Painter> paint_with_pixman(const Canvas& canvas);
[[nodiscard]] std::unique_ptr<Painter> paint_with_qt(const Canvas& canvas);
[[nodiscard]] std::unique_ptr<Painter> paint_with_sdl(const Canvas& canvas);

// Its width and height are not negative.
[[nodiscard]] inline int32_t width_of(const selvage_rect& rect) { return rect.right - rect.left; }
[[nodiscard]] inline int32_t height_of(const selvage_rect& rect) { return rect.bottom - rect.top; }

// A vertex's coordinates as the numbers other libraries want.
[[nodiscard]] inline double x_px(const selvage_vertex& vertex) { return vertex.x / 256.0; }
[[nodiscard]] inline double y_px(const selvage_vertex& vertex) { return vertex.y / 256.0; }
[[nodiscard]] inline double u_texel(const selvage_vertex& vertex) { return vertex.u / 65536.0; }
[[nodiscard]] inline double v_texel(const selvage_vertex& vertex) { return vertex.v / 65536.0; }

}  // namespace selvage::reports
