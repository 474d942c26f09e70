#include "cli/statement.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>

namespace selvage::cli {
namespace {

constexpr size_t kMostQuoted = 60;
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

// What strtod takes besides (hexadecimal, inf, nan) is no number of these files.
[[nodiscard]] std::optional<double> finite_number(const std::string& word) {
  if (word.find_first_not_of("+-.0123456789eE") != std::string::npos) return std::nullopt;
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (end != word.c_str() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

// Takes the next line off, with those that a backslash at its end continues; counts them.
[[nodiscard]] std::string next_line(std::istringstream& stream, int& lines) {
  std::string whole, line;
  while (std::getline(stream, line)) {
    ++lines;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty() || line.back() != '\\') return whole + line;
    line.back() = ' ';
    whole += line;
  }
  return whole;
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
  std::istringstream stream{std::string(text)};
  for (int lines = 0; stream.good();) {
    Statement statement{lines + 1, {}, {}};
    std::istringstream words(next_line(stream, lines));
    for (std::string word; words >> word && word.front() != '#';) statement.words.push_back(word);
    if (statement.words.empty()) continue;
    statement.keyword = statement.words.front();
    statement.words.erase(statement.words.begin());
    statements.push_back(std::move(statement));
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

std::string joined(const std::vector<std::string>& words, size_t first) {
  std::string all;
  for (size_t i = first; i < words.size(); ++i) all += (i == first ? "" : " ") + words[i];
  return all;
}

}  // namespace selvage::cli
