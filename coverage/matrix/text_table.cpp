#include <algorithm>
#include <cstdio>

#include "coverage/matrix/render.h"
#include "spec/profiles.h"

namespace selvage::coverage {
namespace {

constexpr int kColumn = 5;

[[nodiscard]] std::string cell_text(const Cell& cell) {
  switch (cell.fate) {
    case Fate::kKilled:
      return std::to_string(cell.cases);
    case Fate::kPassed:
      return "-";
    case Fate::kNotJudged:
      return "0";
    default:
      return "";
  }
}

[[nodiscard]] std::string right_aligned(const std::string& text) {
  const size_t width = kColumn;
  return std::string(text.size() < width ? width - text.size() : 1, ' ') + text;
}

// The laws' names from top to bottom, their ends on one line.
[[nodiscard]] std::string header(size_t name_width) {
  size_t height = 0;
  for (const spec::Law& law : spec::laws()) height = std::max(height, law.name.size());
  std::string text;
  for (size_t line = 0; line < height; ++line) {
    text += std::string(name_width, ' ');
    for (const spec::Law& law : spec::laws()) {
      const size_t above = height - law.name.size();
      text += right_aligned(line < above ? " " : std::string(1, law.name[line - above]));
    }
    text += '\n';
  }
  return text;
}

}  // namespace

std::string text_table(const Matrix& matrix) {
  size_t name_width = std::string_view("of which no other law does").size();
  for (const Row& row : matrix.rows) name_width = std::max(name_width, row.mapper->name.size());
  const auto named = [&](std::string name) {
    name.resize(name_width, ' ');
    return name;
  };
  std::string text = header(name_width);
  for (const Row& row : matrix.rows) {
    text += named(row.mapper->name);
    for (const Cell& cell : row.cells) text += right_aligned(cell_text(cell));
    text += '\n';
  }
  std::string kills = named("kills"), sole = named("of which no other law does");
  for (size_t i = 0; i < spec::laws().size(); ++i) {
    const Tally of_law = tally(matrix, i);
    kills += right_aligned(std::to_string(of_law.kills));
    sole += right_aligned(std::to_string(of_law.sole));
  }
  return text + kills + '\n' + sole + '\n';
}

}  // namespace selvage::coverage
