#include "reports/scenes/animation.h"

#include <stdexcept>

#include "cli/apng.h"
#include "scene/draw.h"

namespace selvage::reports {

std::vector<uint8_t> animation(const scene::Scene& scene, double turn_s, const scene::Size& size,
                               uint32_t frames, const std::function<void()>& tick) {
  cli::Apng film(frames, cli::frame_delay(frames / turn_s));
  const scene::Wish wish{scene.tolerance_texel, std::nullopt};
  for (uint32_t i = 0; i < frames; ++i) {
    tick();
    cli::Raster frame = cli::filled(size.width_px, size.height_px, {});
    const selvage_image image{frame.rgba.data(), size.width_px, size.height_px,
                              static_cast<ptrdiff_t>(size.width_px) * 4, SELVAGE_RGBA8888};
    const scene::Drawing drawing =
        compose(scene, turn_s * i / frames, size, wish, scene::Hidden::kScanLine);
    const selvage_status status = draw(scene, drawing, image);
    if (status != SELVAGE_OK) throw std::runtime_error(selvage_status_text(status));
    film.add(frame);
  }
  return film.finish();
}

}  // namespace selvage::reports
