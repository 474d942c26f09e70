// Scenes in perspective.
#include "reports/gallery/camera.h"
#include "reports/gallery/scenes.h"
#include "reports/gallery/shapes.h"

namespace selvage::reports {

namespace {

struct PlaneView {
  double near_z = 1, far_z = 40;  // of its edges, in heights of the eye above the plane
  double half_width = 30;         // likewise
  double horizon_y_px = 60, focal_px = 300, roll_degree = 0;
  double repeats_per_height = 0.25;  // of the picture, along u; square texels
};

// A level plane under the eye, the picture repeated on it.
Polygon level_plane(const cli::Raster& picture, const PlaneView& view) {
  const Camera camera{240, view.horizon_y_px, view.focal_px, view.near_z};
  const double texels = picture.width_px * view.repeats_per_height;
  const auto corner = [&](double x, double z) {
    return camera.see(turned_about_z({x, 1, z}, view.roll_degree), x * texels,
                      (view.far_z - z) * texels);
  };
  return {{corner(-view.half_width, view.far_z), corner(view.half_width, view.far_z),
           corner(view.half_width, view.near_z), corner(-view.half_width, view.near_z)},
          &picture,
          SELVAGE_ADDRESS_WRAP};
}

}  // namespace

Scene endless_plane(const Pictures& pictures) {
  Scene scene;
  scene.id = "plane";
  scene.title = "A tilted plane of maps";
  scene.sentence =
      "One quad in perspective, far wider than the picture, its texture wrapped: 1/w is "
      "interpolated, and every pixel is divided out exactly.";
  PlaneView view;
  view.roll_degree = -9;
  view.half_width = 24;
  view.far_z = 24;
  view.repeats_per_height = 0.3;
  scene.polygons = {level_plane(pictures.earth, view)};
  return scene;
}

Scene moire(const Pictures& pictures) {
  Scene scene;
  scene.id = "moire";
  scene.title = "Moir\u00e9";
  scene.sentence =
      "A checker to the horizon without a filter: aliasing makes rings out of the least change of "
      "a coordinate. "
      "This is the moir\u00e9 of the exact map, ring for ring.";
  PlaneView view;
  view.roll_degree = 6;
  view.half_width = 60;
  view.far_z = 80;
  view.repeats_per_height = 0.5;
  scene.polygons = {level_plane(pictures.checker, view)};
  return scene;
}

Scene globe_scene(const Pictures& pictures) {
  Scene scene;
  scene.id = "globe";
  scene.title = "The Earth as a globe";
  scene.sentence =
      "Cells of 10 x 10 degrees, a quad each, in perspective: neighbours share their vertices, "
      "and no pixel between them is missing or drawn twice.";
  GlobeView view;
  view.east_degree = -15;
  view.north_degree = 28;
  view.roll_degree = 12;
  scene.polygons = quads(globe(view, pictures.earth), pictures.earth);
  return scene;
}

Scene wave_scene(const Pictures& pictures) {
  Scene scene;
  scene.id = "waves";
  scene.title = "A map on waves";
  scene.sentence =
      "A mesh of 1600 triangles over a wavy sheet, in perspective: every edge inside it is shared "
      "by "
      "two triangles, and no pixel along it is missing or drawn twice.";
  scene.polygons = triangles(wave({}, pictures.earth), pictures.earth);
  return scene;
}

std::vector<Scene> scenes(const Pictures& pictures) {
  return {turned_map(pictures), endless_plane(pictures), globe_scene(pictures),
          wave_scene(pictures), pinwheel(pictures),      checker_of_ties(pictures),
          moire(pictures),      spacecraft(pictures)};
}

}  // namespace selvage::reports
