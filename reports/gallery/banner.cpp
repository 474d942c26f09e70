#include "reports/gallery/banner.h"

#include <utility>

#include "cli/bitmap.h"
#include "reports/gallery/draw.h"
#include "reports/gallery/shapes.h"

namespace selvage::reports {

namespace {

void append(std::vector<Polygon>& polygons, std::vector<Polygon> more) {
  for (Polygon& polygon : more) polygons.push_back(std::move(polygon));
}

}  // namespace

cli::Raster draw_banner(const Pictures& pictures) {
  // Smaller pictures, closer to a texel a pixel: there is no filter to take out what lies between.
  const cli::Raster earth = halved(pictures.earth), map = halved(earth);
  Scene scene;
  scene.id = "banner";
  scene.width_px = 960;
  scene.height_px = 320;
  scene.background = {13, 17, 27, 255};

  WaveView sheet;
  sheet.centre_x_px = 610;
  sheet.centre_y_px = 168;
  sheet.focal_px = 560;
  sheet.amplitude = 0.2;
  sheet.roll_degree = -4;
  sheet.pitch_degree = 38;
  const Grid waves = wave(sheet, map);
  append(scene.polygons, triangles(waves, map));
  append(scene.polygons,
         outlines(triangles(waves.columns_between(24, 40), map), 0.8, pictures.grid_line));

  GlobeView ball;
  ball.centre_x_px = 170;
  ball.centre_y_px = 160;
  ball.radius_px = 142;
  ball.east_degree = -20;
  ball.north_degree = 25;
  ball.roll_degree = 14;
  append(scene.polygons, quads(globe(ball, earth), earth));
  // Fewer levels make a smaller file.
  return cli::to_raster(cli::to_bitmap(draw_by_mapper(scene), SELVAGE_RGB565));
}

}  // namespace selvage::reports
