// The lines of an OBJ file, for what its parser lets pass and for where things stand.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace selvage::cli {

struct ObjLines {
  std::vector<int> faces;                              // of each f, in order
  std::vector<int> libraries;                          // of each mtllib
  std::vector<std::pair<int, std::string>> materials;  // of each usemtl, and what it names
};

// Refuses numbers that are none, and faces of fewer than 3 corners: "FILE:LINE: what is wrong".
[[nodiscard]] ObjLines check_obj_lines(const std::string& file, std::string_view text);

}  // namespace selvage::cli
