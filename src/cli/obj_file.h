// Wavefront OBJ and MTL: an object with its materials and textures.
//
// Read: v, vt, f (n-gons are kept), usemtl, mtllib; of materials Kd, illum and map_Kd with -clamp.
// illum 1 and more is lit by the ambient light and the lamps, 0 or none is shown as it is. v of a
// texture runs upward there and downward here, so it is turned over.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "scene/object.h"
#include "scene/scene.h"

namespace selvage::cli {

// Pictures in the place of those that materials name, by material.
using TextureFiles = std::map<std::string, std::filesystem::path>;

// Textures are added to the scene's. Errors name the file and, where it is one line's, the line.
[[nodiscard]] scene::Object read_obj(const std::filesystem::path& path,
                                     const TextureFiles& textures, scene::Scene& scene);

}  // namespace selvage::cli
