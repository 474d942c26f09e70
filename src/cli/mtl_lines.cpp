#include "cli/mtl_lines.h"

#include <algorithm>
#include <array>

#include "cli/statement.h"

namespace selvage::cli {
namespace {

// Statements of the format and of its usual extensions that have no say in a picture here.
constexpr std::array<std::string_view, 42> kMtlKeywordsLeftOut = {
    "Ka",     "Ks",     "Ke",     "Km",       "Ns",       "Ni",        "d",
    "Tr",     "Tf",     "map_Ka", "map_Ks",   "map_Ke",   "map_Ns",    "map_Ni",
    "map_d",  "map_Tr", "map_Tf", "map_bump", "map_Bump", "bump",      "Bump",
    "disp",   "decal",  "refl",   "map_refl", "norm",     "map_aat",   "map_disp",
    "Pr",     "Pm",     "Ps",     "Pc",       "Pcr",      "aniso",     "anisor",
    "map_Pr", "map_Pm", "map_Ps", "map_RMA",  "map_ORM",  "sharpness", "Kt"};

void add_material(const std::string& file, const Statement& statement, MtlLines& lines) {
  const std::string name = material_name(file, statement);
  const bool known = std::any_of(lines.materials.begin(), lines.materials.end(),
                                 [&](const MtlMaterial& other) { return other.name == name; });
  if (known) throw wrong(file, statement, quoted(name) + " stands twice");
  lines.materials.push_back({name, statement.line, 0});
}

void check_illumination(const std::string& file, const Statement& statement) {
  const std::string& model = only_word(file, statement);
  const bool is_digit = model.size() == 1 && model[0] >= '0' && model[0] <= '9';
  if (!is_digit && model != "10") {
    throw wrong(file, statement, "a whole number from 0 to 10 is needed, not " + quoted(model));
  }
}

// [-clamp on|off] and the picture's name
void check_texture(const std::string& file, const Statement& statement) {
  const std::vector<std::string>& words = statement.words;
  size_t name = 0;
  for (; name < words.size() && words[name].front() == '-'; name += 2) {
    const bool is_told =
        name + 1 < words.size() && (words[name + 1] == "on" || words[name + 1] == "off");
    if (words[name] != "-clamp" || !is_told) {
      throw wrong(file, statement,
                  quoted(words[name]) + ": of options only -clamp on and -clamp off are heeded");
    }
  }
  if (name == words.size()) throw wrong(file, statement, "the name of a picture is needed");
}

}  // namespace

MtlLines check_mtl_lines(const std::string& file, std::string_view text) {
  MtlLines lines;
  for (const Statement& statement : statements_of(text)) {
    const std::string& keyword = statement.keyword;
    std::string words = joined(statement.words);
    if (keyword == "newmtl") {
      add_material(file, statement, lines);
      words = as_one_word(words);
    } else if (keyword == "Kd") {
      words = numbers(file, statement, 3, 3);
    } else if (keyword == "illum") {
      check_illumination(file, statement);
    } else if (keyword == "map_Kd") {
      check_texture(file, statement);
    } else if (std::ranges::find(kMtlKeywordsLeftOut, keyword) != kMtlKeywordsLeftOut.end()) {
      continue;
    } else {
      throw UserError(file + ":" + std::to_string(statement.line) + ": " + quoted(keyword) +
                      " begins no statement of materials; newmtl, Kd, illum and map_Kd are read");
    }
    if (lines.materials.empty()) throw wrong(file, statement, "a newmtl is needed before");
    if (keyword == "map_Kd") lines.materials.back().texture_line = statement.line;
    lines.statements += keyword + " " + words + '\n';
  }
  if (lines.materials.empty()) throw UserError(file + ": there is no newmtl in it");
  return lines;
}

}  // namespace selvage::cli
