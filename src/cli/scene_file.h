// A scene from its JSON file and the OBJ files that it names.
#pragma once

#include <filesystem>

#include "scene/scene.h"

namespace selvage::cli {

// Files in it are named from its own folder. Errors are UserErrors "FILE:LINE: what is wrong".
[[nodiscard]] scene::Scene read_scene(const std::filesystem::path& path);

}  // namespace selvage::cli
