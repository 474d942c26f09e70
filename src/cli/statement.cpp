#include "cli/statement.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>

namespace selvage::cli {
namespace {

constexpr size_t kMostQuoted = 60;
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
constexpr const char* kWordSeparators = " \t\v\f";

// What strtod takes besides (hexadecimal, inf, nan) is no number of these files.
[[nodiscard]] std::optional<double> finite_number(const std::string& word) {
  if (word.find_first_not_of("+-.0123456789eE") != std::string::npos) return std::nullopt;
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (end != word.c_str() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

// LF in the place of CR LF and of CR alone.
[[nodiscard]] std::string with_line_feeds(std::string_view text) {
  std::string all;
  all.reserve(text.size());
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
    all += text[i] == '\r' ? '\n' : text[i];
  }
  return all;
}

// Takes the next line off, with those that a backslash at its end continues; counts them.
[[nodiscard]] std::string next_line(std::istringstream& stream, int& lines) {
  std::string whole, line;
  while (std::getline(stream, line)) {
    ++lines;
    if (line.empty() || line.back() != '\\') return whole + line;
    line.back() = ' ';
    whole += line;
  }
  return whole;
}

[[nodiscard]] Statement statement_of(const std::string& line, int number) {
  Statement statement{number, {}, {}, {}};
  size_t rest = 0, end = 0;
  for (;;) {
    const size_t begin = line.find_first_not_of(kWordSeparators, end);
    if (begin == std::string::npos || line[begin] == '#') break;
    end = std::min(line.find_first_of(kWordSeparators, begin), line.size());
    const std::string word = line.substr(begin, end - begin);
    if (statement.keyword.empty()) {
      statement.keyword = word;
      continue;
    }
    if (statement.words.empty()) rest = begin;
    statement.words.push_back(word);
  }
  if (!statement.words.empty()) statement.rest = line.substr(rest, end - rest);
  return statement;
}

}  // namespace

std::string quoted(const std::string& word) {
  std::string text = word.substr(0, kMostQuoted);
  for (char& letter : text) {
    if (letter < ' ' || letter > '~') letter = '?';
  }
  return "'" + text + (word.size() > kMostQuoted ? "...'" : "'");
}

std::vector<Statement> statements_of(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::vector<Statement> statements;
  std::istringstream stream{with_line_feeds(text)};
  for (int lines = 0; stream.good();) {
    const int first = lines + 1;
    Statement statement = statement_of(next_line(stream, lines), first);
    if (!statement.keyword.empty()) statements.push_back(std::move(statement));
  }
  return statements;
}

UserError wrong(const std::string& file, const Statement& statement, const std::string& what) {
  return UserError(file + ":" + std::to_string(statement.line) + ": " + statement.keyword + ": " +
                   what);
}

std::string numbers(const std::string& file, const Statement& statement, size_t least,
                    size_t most) {
  const size_t count = statement.words.size();
  if (count < least || count > most) {
    const std::string so_many = least == most
                                    ? std::to_string(least)
                                    : std::to_string(least) + " to " + std::to_string(most);
    throw wrong(file, statement, so_many + " numbers are needed, not " + std::to_string(count));
  }
  std::string all;
  for (const std::string& word : statement.words) {
    const std::optional<double> value = finite_number(word);
    if (!value) throw wrong(file, statement, quoted(word) + " is no finite number");
    char shortest[32];
    char* const end = std::to_chars(shortest, shortest + sizeof shortest, *value).ptr;
    all += (all.empty() ? "" : " ") + std::string(shortest, end);
  }
  return all;
}

const std::string& only_word(const std::string& file, const Statement& statement) {
  if (statement.words.size() != 1) {
    throw wrong(file, statement,
                "one word is needed, not " + std::to_string(statement.words.size()));
  }
  return statement.words.front();
}

std::string material_name(const std::string& file, const Statement& statement) {
  if (statement.words.empty()) throw wrong(file, statement, "the name of a material is needed");
  return joined(statement.words);
}

std::string as_one_word(const std::string& name) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string word;
  for (const char letter : name) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte > ' ' && letter != '%') {
      word += letter;
    } else {
      word += {'%', kDigits[byte / 16], kDigits[byte % 16]};
    }
  }
  return word;
}

std::string joined(const std::vector<std::string>& words, size_t first) {
  std::string all;
  for (size_t i = first; i < words.size(); ++i) all += (i == first ? "" : " ") + words[i];
  return all;
}

}  // namespace selvage::cli
