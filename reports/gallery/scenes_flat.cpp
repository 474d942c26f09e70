// Scenes without depth.
#include <cmath>
#include <numbers>

#include "reports/gallery/camera.h"
#include "reports/gallery/scenes.h"

namespace selvage::reports {

namespace {

// The whole picture on a rectangle about a centre, turned.
Polygon turned_rectangle(const cli::Raster& picture, double centre_x_px, double centre_y_px,
                         double width_px, double degree) {
  const double w = picture.width_px, h = picture.height_px, height_px = width_px * h / w;
  const auto corner = [&](double across, double down) {
    const Point p =
        turned_about_z({(across - 0.5) * width_px, (down - 0.5) * height_px, 0}, degree);
    return flat_vertex(centre_x_px + p.x, centre_y_px + p.y, across * w, down * h);
  };
  return {
      {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)}, &picture, SELVAGE_ADDRESS_CLAMP};
}

}  // namespace

Scene turned_map(const Pictures& pictures) {
  Scene scene;
  scene.id = "turned-map";
  scene.title = "A map of the Earth, turned";
  scene.sentence =
      "One affine quad, turned by 17 degrees and about five texels a pixel each way, so that "
      "neighbouring pixels show texels far apart: any slip would show as another place.";
  scene.polygons = {turned_rectangle(pictures.earth, 240, 150, 380, 17)};
  return scene;
}

Scene pinwheel(const Pictures& pictures) {
  constexpr int32_t blades = 24;
  constexpr double centre_x_px = 240.5, centre_y_px = 150.5, radius_px = 140;
  Scene scene;
  scene.id = "pinwheel";
  scene.title = "A pinwheel about one pixel's centre";
  scene.sentence =
      "24 triangles with two pictures in turn meet in one vertex that lies exactly on a sample "
      "point: exactly one of them owns that pixel, and no pixel along the spokes is lost or drawn "
      "twice.";
  const cli::Raster* faces[] = {&pictures.earth, &pictures.checker};
  const auto rim = [&](int32_t i, const cli::Raster& picture) {
    const double angle = 2 * std::numbers::pi * i / blades;
    const double x = std::cos(angle), y = std::sin(angle);
    return flat_vertex(centre_x_px + radius_px * x, centre_y_px + radius_px * y,
                       picture.width_px * (0.5 + 0.25 * x), picture.height_px * (0.5 + 0.5 * y));
  };
  for (int32_t i = 0; i < blades; ++i) {
    const cli::Raster& picture = *faces[i % 2];
    scene.polygons.push_back(
        {{flat_vertex(centre_x_px, centre_y_px, picture.width_px * 0.5, picture.height_px * 0.5),
          rim(i, picture), rim((i + 1) % blades, picture)},
         &picture,
         SELVAGE_ADDRESS_CLAMP});
  }
  return scene;
}

Scene checker_of_ties(const Pictures& pictures) {
  constexpr double x = 240.5, y = 150.5, reach_px = 128;
  const double end = pictures.checker.width_px;
  Scene scene;
  scene.id = "ties";
  scene.title = "A checker of ties";
  scene.sentence =
      "A square standing on its corner with all vertices on sample points: its edges and the "
      "borders of its texels run exactly through pixel centres, where only the half-open rule "
      "decides.";
  scene.polygons = {{{flat_vertex(x, y - reach_px, 0, 0), flat_vertex(x + reach_px, y, end, 0),
                      flat_vertex(x, y + reach_px, end, end), flat_vertex(x - reach_px, y, 0, end)},
                     &pictures.checker,
                     SELVAGE_ADDRESS_CLAMP}};
  return scene;
}

Scene spacecraft(const Pictures& pictures) {
  Scene scene;
  scene.id = "spacecraft";
  scene.title = "Spacecraft, magnified";
  scene.sentence =
      "Three small pictures, a texel several pixels wide: every texel's outline is a straight edge "
      "at the exact place.";
  scene.polygons = {turned_rectangle(pictures.iss, 160, 160, 270, -14),
                    turned_rectangle(pictures.hubble, 372, 96, 140, 23),
                    turned_rectangle(pictures.shuttle, 375, 222, 150, -8)};
  return scene;
}

}  // namespace selvage::reports
