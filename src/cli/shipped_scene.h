// Where the scenes are that come with the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace selvage::cli {

// Of the scene of that name: beside the installed program, then in the tree it was built from.
[[nodiscard]] std::vector<std::filesystem::path> shipped_scene_places(const std::string& name);

// The first that is a file; a UserError that names them all if none is.
[[nodiscard]] std::filesystem::path first_scene(const std::vector<std::filesystem::path>& places);

}  // namespace selvage::cli
