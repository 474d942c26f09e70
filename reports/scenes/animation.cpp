#include "reports/scenes/animation.h"

#include <stdexcept>

#include "cli/apng.h"
#include "scene/draw.h"

namespace selvage::reports {

cli::Raster picture(const scene::Scene& scene, std::optional<selvage_filter> filter, double time_s,
                    const scene::Size& size) {
  cli::Raster raster = cli::filled(size.width_px, size.height_px, {});
  const selvage_image image{raster.rgba.data(), size.width_px, size.height_px,
                            static_cast<ptrdiff_t>(size.width_px) * 4, SELVAGE_RGBA8888};
  const selvage_status status =
      draw(scene, compose(scene, time_s, size, {0, filter}, scene::Hidden::kScanLine), image);
  if (status != SELVAGE_OK) throw std::runtime_error(selvage_status_text(status));
  return raster;
}

std::vector<uint8_t> animation(const scene::Scene& scene, const Shipped& shipped,
                               const scene::Size& size, uint32_t frames,
                               const std::function<void()>& tick) {
  cli::Apng film(frames, cli::frame_delay(frames / shipped.turn_s));
  for (uint32_t i = 0; i < frames; ++i) {
    tick();
    film.add(picture(scene, shipped.filter, shipped.turn_s * i / frames, size));
  }
  return film.finish();
}

}  // namespace selvage::reports
