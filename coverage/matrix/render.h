// The matrix for a terminal, for a browser and for other programs.
#pragma once

#include <string>

#include "coverage/matrix/matrix.h"

namespace selvage::coverage {

// Rows of mappers, columns of laws: the cases that it took to kill, - where the law passes it,
// 0 where it judged nothing, nothing where the profile does not promise the law.
[[nodiscard]] std::string text_table(const Matrix& matrix);
// One document, light or dark as the reader's system is, with nothing from outside.
[[nodiscard]] std::string html_page(const Matrix& matrix);
[[nodiscard]] std::string json_text(const Matrix& matrix);

}  // namespace selvage::coverage
