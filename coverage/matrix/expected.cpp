#include "coverage/matrix/expected.h"

#include <sstream>
#include <stdexcept>

namespace selvage::coverage {

ExpectedKillers read_expected(std::istream& in) {
  ExpectedKillers expected;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    line = line.substr(0, line.find('#'));
    if (line.find_first_not_of(' ') == std::string::npos) continue;
    const size_t colon = line.find(':');
    if (colon == std::string::npos || colon == 0) {
      throw std::runtime_error("line " + std::to_string(number) +
                               " names no mapper: \"MAPPER: LAW LAW ...\" is meant");
    }
    const auto [entry, is_new] = expected.try_emplace(line.substr(0, colon));
    if (!is_new) {
      throw std::runtime_error("line " + std::to_string(number) + " names " + entry->first +
                               " again");
    }
    std::istringstream laws(line.substr(colon + 1));
    for (std::string law; laws >> law;) entry->second.insert(law);
  }
  return expected;
}

ExpectedKillers expected_of(const Matrix& matrix) {
  ExpectedKillers killers;
  for (const Row& row : matrix.rows) {
    std::set<std::string>& laws = killers[row.mapper->name];
    for (size_t i = 0; i < row.cells.size(); ++i) {
      if (row.cells[i].fate == Fate::kKilled) laws.insert(std::string(spec::laws()[i].name));
    }
  }
  return killers;
}

std::string expected_text(const Matrix& matrix) {
  const auto& [first_seed, cases, killer_cases] = matrix.budget;
  std::string text = "# Which laws kill which wrong mapper within " + std::to_string(cases) +
                     " cases from seed " + std::to_string(first_seed) +
                     " on; the law that the catalogue\n# names, within " +
                     std::to_string(killer_cases) +
                     ". Written by coverage/killers --write, in a build with OpenCV.\n";
  for (const Row& row : matrix.rows) {
    text += row.mapper->name + ":";
    for (size_t i = 0; i < row.cells.size(); ++i) {
      if (row.cells[i].fate == Fate::kKilled) text += " " + std::string(spec::laws()[i].name);
    }
    text += "\n";
  }
  return text;
}

std::vector<std::string> differences(const ExpectedKillers& expected, const Matrix& matrix) {
  std::vector<std::string> told;
  const ExpectedKillers seen = expected_of(matrix);
  for (const auto& [mapper, laws] : seen) {
    const auto entry = expected.find(mapper);
    if (entry == expected.end()) {
      told.push_back(mapper + " is not in the table");
      continue;
    }
    for (const std::string& law : laws) {
      if (!entry->second.contains(law)) told.push_back(law + " kills " + mapper + " by now");
    }
    for (const std::string& law : entry->second) {
      if (!laws.contains(law) && spec::find_law(law) != nullptr) {
        told.push_back(law + " no longer kills " + mapper);
      }
    }
  }
  return told;
}

}  // namespace selvage::coverage
