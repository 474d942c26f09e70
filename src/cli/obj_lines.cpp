#include "cli/obj_lines.h"

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "cli/error.h"

namespace selvage::cli {
namespace {

[[nodiscard]] bool is_finite_number(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  return end == word.c_str() + word.size() && std::isfinite(value);
}

void check_numbers(const std::string& where, const std::string& keyword, size_t least,
                   const std::vector<std::string>& words) {
  if (words.size() < least) {
    throw UserError(where + keyword + " needs " + std::to_string(least) + " numbers");
  }
  for (const std::string& word : words) {
    if (!is_finite_number(word)) throw UserError(where + "'" + word + "' is no finite number");
  }
}

}  // namespace

ObjLines check_obj_lines(const std::string& file, std::string_view text) {
  ObjLines lines;
  std::istringstream stream{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    const std::string where = file + ":" + std::to_string(number) + ": ";
    std::istringstream parts(line.substr(0, line.find('#')));
    std::string keyword;
    parts >> keyword;
    std::vector<std::string> words;
    for (std::string word; parts >> word;) words.push_back(word);
    if (keyword == "v") check_numbers(where, keyword, 3, words);
    if (keyword == "vt") check_numbers(where, keyword, 2, words);
    if (keyword == "mtllib") lines.libraries.push_back(number);
    if (keyword == "usemtl") lines.materials.emplace_back(number, words.empty() ? "" : words[0]);
    if (keyword != "f") continue;
    if (words.size() < 3) {
      throw UserError(where + "a face needs at least 3 corners, not " +
                      std::to_string(words.size()));
    }
    lines.faces.push_back(number);
  }
  return lines;
}

}  // namespace selvage::cli
