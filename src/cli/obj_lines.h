// The lines of an OBJ file: checked, for its parser lets much pass, and where things stand.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace selvage::cli {

// Indices as they are written: from 1, or backward from the last so far, -1.
struct ObjCorner {
  int vertex;
  int texture;  // 0 without
};

struct ObjFace {
  int line;
  std::vector<ObjCorner> corners;
};

// A mtllib's: one file of that whole name, or one of each word.
struct ObjLibraries {
  int line;
  std::string whole;
  std::vector<std::string> words;
};

struct ObjLines {
  std::string statements;               // v, vt, f and usemtl (names as one word), for the parser
  std::vector<int> vertices;            // the line of each v, in order
  std::vector<ObjFace> faces;           // each f, in order
  std::vector<ObjLibraries> libraries;  // each mtllib, in order
  std::vector<std::pair<int, std::string>> materials;  // of each usemtl: line and name
};

// What is no statement of such a file, numbers that are none, and faces of fewer than 3 corners are
// UserErrors "FILE:LINE: KEYWORD: what is wrong".
[[nodiscard]] ObjLines check_obj_lines(const std::string& file, std::string_view text);

}  // namespace selvage::cli
