// Wavefront OBJ and MTL: an object with its materials and textures.
//
// Read: v, vt, f (n-gons are kept), usemtl, mtllib; of materials Kd, illum and map_Kd with -clamp.
// illum 1 and more is lit by the ambient light and the lamps, 0 or none is shown as it is. v of a
// texture runs upward there and downward here, so it is turned over. A material library's pictures
// are named from its own folder. Names of materials may have blanks, of which several count as one;
// mtllib takes the rest of its line if that file is there, else a file of each word.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "scene/object.h"
#include "scene/scene.h"

namespace selvage::cli {

// Where the files of a scene come from.
struct SceneFiles {
  // Pictures in the place of those that materials name, by material.
  std::map<std::string, std::filesystem::path> textures;
  // The bytes of a file, or a UserError; the disk's, if empty.
  std::function<std::vector<uint8_t>(const std::filesystem::path&)> read;

  [[nodiscard]] std::vector<uint8_t> bytes(const std::filesystem::path& path) const;
  [[nodiscard]] std::string text(const std::filesystem::path& path) const;
  [[nodiscard]] bool has(const std::filesystem::path& path) const;
};

// In the place of a material's own picture, by material.
struct OtherPicture {
  std::filesystem::path path;
  std::string asked_by;  // for messages
};
using OtherPictures = std::map<std::string, OtherPicture>;

// The object of an OBJ file's text; `path` is where its libraries are named from. Textures are
// added to the scene's. Errors name the file and, where it is one line's, the line.
[[nodiscard]] scene::Object read_obj(const std::filesystem::path& path, const std::string& text,
                                     const SceneFiles& files, const OtherPictures& others,
                                     scene::Scene& scene);

}  // namespace selvage::cli
