// The committed table of which laws kill which wrong mapper, coverage/expected_killers.txt: the
// tests hold the catalogue against it, the command the whole matrix.
#pragma once

#include <istream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "coverage/matrix/matrix.h"

namespace selvage::coverage {

// By the mapper's name.
using ExpectedKillers = std::map<std::string, std::set<std::string>, std::less<>>;

// Lines "MAPPER: LAW LAW ...", and comments after #. A std::runtime_error names a line that is
// none.
[[nodiscard]] ExpectedKillers read_expected(std::istream& in);

[[nodiscard]] ExpectedKillers expected_of(const Matrix& matrix);

// The whole file.
[[nodiscard]] std::string expected_text(const Matrix& matrix);

// What the matrix shows otherwise, a sentence each; laws that this build lacks are not missed.
[[nodiscard]] std::vector<std::string> differences(const ExpectedKillers& expected,
                                                   const Matrix& matrix);

}  // namespace selvage::coverage
