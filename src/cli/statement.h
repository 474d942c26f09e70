// The statements of Wavefront files: a keyword and words, one a line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/error.h"

namespace selvage::cli {

struct Statement {
  int line;  // the first, of a statement that backslashes continue
  std::string keyword;
  std::vector<std::string> words;
  std::string rest;  // the words with the blanks between them, as they stand
};

// All that is neither blank nor a comment, which a word that begins with # opens. A byte order mark
// in front is none of it. Lines end by LF, CR LF or CR.
[[nodiscard]] std::vector<Statement> statements_of(std::string_view text);

// For error texts: no more than its beginning, and nothing that a terminal would take amiss.
[[nodiscard]] std::string quoted(const std::string& word);

// "FILE:LINE: KEYWORD: what is wrong"
[[nodiscard]] UserError wrong(const std::string& file, const Statement& statement,
                              const std::string& what);

// All words, which are finite decimal numbers, from `least` to `most` of them, each in its shortest
// form, with a space between.
[[nodiscard]] std::string numbers(const std::string& file, const Statement& statement, size_t least,
                                  size_t most);

// The only word.
[[nodiscard]] const std::string& only_word(const std::string& file, const Statement& statement);

// The name of a material: all words, with a space between.
[[nodiscard]] std::string material_name(const std::string& file, const Statement& statement);

// A name as one word, its blanks and control characters as %20 and so on, for a parser that takes
// none. Different for different names.
[[nodiscard]] std::string as_one_word(const std::string& name);

// The words, or those behind the first, with a space between.
[[nodiscard]] std::string joined(const std::vector<std::string>& words, size_t first = 0);

}  // namespace selvage::cli
