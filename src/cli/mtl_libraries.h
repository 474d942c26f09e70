// The material libraries of an OBJ file, all of them.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "cli/mtl_lines.h"
#include "cli/obj_file.h"
#include "cli/obj_lines.h"

namespace selvage::cli {

struct MtlPlace {
  std::string file;
  MtlMaterial material;
};

struct MtlLibraries {
  std::vector<std::string> texts;   // of each library, for the parser
  std::vector<MtlPlace> materials;  // of all of them, in order

  // Null if there is none of that name.
  [[nodiscard]] const MtlPlace* find(const std::string& name) const;
};

// Reads each file once. What follows a mtllib is one file's name, blanks and all, if that file is
// there; else each word is one. Two materials of one name are a UserError that tells both places.
[[nodiscard]] MtlLibraries read_libraries(const std::filesystem::path& obj,
                                          std::span<const ObjLibraries> asked,
                                          const SceneFiles& files);

}  // namespace selvage::cli
