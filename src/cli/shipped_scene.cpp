#include "cli/shipped_scene.h"

#include "cli/error.h"

namespace selvage::cli {

namespace fs = std::filesystem;

std::vector<fs::path> shipped_scene_places(const std::string& name) {
  const fs::path file = fs::path(name) / (name + ".json");
  std::vector<fs::path> places;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    const fs::path installed = program.parent_path() / SELVAGE_DATA_FROM_PROGRAM / "scenes";
    places.push_back((installed / file).lexically_normal());
  }
  places.push_back(fs::path(SELVAGE_SHIPPED_SCENES) / file);
  return places;
}

fs::path first_scene(const std::vector<fs::path>& places) {
  std::string tried;
  for (const fs::path& place : places) {
    std::error_code error;
    if (fs::is_regular_file(place, error)) return place;
    tried += "\n  " + place.string();
  }
  throw UserError("the scene that comes with selvage is not there; looked for" + tried +
                  "\nInstall it, or name a scene: selvage demo SCENE.json");
}

}  // namespace selvage::cli
