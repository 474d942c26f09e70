#include "cli/obj_lines.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "cli/statement.h"

namespace selvage::cli {
namespace {

// Statements that have no say in a picture of plane faces here.
constexpr std::array kObjKeywordsLeftOut = {
    "vn",     "g",      "s",     "mg",       "o",        "p",          "l",        "lod",
    "usemap", "maplib", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"};

// An index, or 0 if it is none.
[[nodiscard]] int index_of(std::string_view text) {
  int index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  return error == std::errc{} && end == text.data() + text.size() ? index : 0;
}

// "vertex", "vertex/texture", "vertex//normal" or "vertex/texture/normal", without the normal.
[[nodiscard]] ObjCorner corner(const std::string& file, const Statement& face,
                               const std::string& word) {
  std::string_view rest = word;
  std::array<std::string_view, 3> parts;
  size_t count = 0;
  for (;; rest = rest.substr(parts[count - 1].size() + 1)) {
    parts[count++] = rest.substr(0, rest.find('/'));
    if (count == parts.size() || parts[count - 1].size() == rest.size()) break;
  }
  const bool whole = parts[count - 1].size() == rest.size();
  const bool has_texture = count > 1 && !(count == 3 && parts[1].empty());
  const ObjCorner corner{index_of(parts[0]), has_texture ? index_of(parts[1]) : 0};
  if (!whole || corner.vertex == 0 || (has_texture && corner.texture == 0) ||
      (count == 3 && index_of(parts[2]) == 0)) {
    throw wrong(file, face, quoted(word) + " is no corner; 1, 1/2, 1//3 and 1/2/3 are");
  }
  return corner;
}

void add_face(const std::string& file, const Statement& face, ObjLines& lines) {
  if (face.words.size() < 3) {
    throw wrong(file, face,
                "a face needs at least 3 corners, not " + std::to_string(face.words.size()));
  }
  lines.faces.push_back({face.line, {}});
  lines.statements += "f";
  for (const std::string& word : face.words) {
    const ObjCorner at = corner(file, face, word);
    lines.faces.back().corners.push_back(at);
    lines.statements += " " + std::to_string(at.vertex);
    if (at.texture != 0) lines.statements += "/" + std::to_string(at.texture);
  }
  lines.statements += '\n';
}

void add_libraries(const std::string& file, const Statement& statement, ObjLines& lines) {
  if (statement.words.empty()) throw wrong(file, statement, "the name of a file is needed");
  lines.libraries.push_back({statement.line, statement.rest, statement.words});
}

}  // namespace

ObjLines check_obj_lines(const std::string& file, std::string_view text) {
  ObjLines lines;
  for (const Statement& statement : statements_of(text)) {
    const std::string& keyword = statement.keyword;
    if (keyword == "f") {
      add_face(file, statement, lines);
    } else if (keyword == "mtllib") {
      add_libraries(file, statement, lines);
    } else if (keyword == "usemtl") {
      lines.materials.emplace_back(statement.line, material_name(file, statement));
      lines.statements += "usemtl " + as_one_word(lines.materials.back().second) + '\n';
    } else if (keyword == "v" || keyword == "vt") {
      const bool is_vertex = keyword == "v";  // may have a w or a colour behind, textures a w
      if (is_vertex) lines.vertices.push_back(statement.line);
      lines.statements +=
          keyword + " " + numbers(file, statement, is_vertex ? 3 : 2, is_vertex ? 7 : 3) + '\n';
    } else if (std::find(kObjKeywordsLeftOut.begin(), kObjKeywordsLeftOut.end(), keyword) ==
               kObjKeywordsLeftOut.end()) {
      throw UserError(file + ":" + std::to_string(statement.line) + ": " + quoted(keyword) +
                      " begins no statement that is read here; v, vt, f, usemtl and mtllib do");
    }
  }
  return lines;
}

}  // namespace selvage::cli
