// A scene from its JSON file and the OBJ files that it names.
#pragma once

#include <filesystem>

#include "cli/obj_file.h"
#include "scene/scene.h"

namespace selvage::cli {

// Files in it are named from its own folder. Errors are UserErrors "FILE:LINE: what is wrong".
// Each of `files.textures` takes the place of one that a material names.
[[nodiscard]] scene::Scene read_scene(const std::filesystem::path& path,
                                      const SceneFiles& files = {});

}  // namespace selvage::cli
