#include "cli/corpus.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <system_error>

#include "cli/error.h"
#include "cli/file.h"
#include "cli/number.h"
#include "spec/profiles.h"

namespace selvage::cli {
namespace {

constexpr size_t kMaxFileOfCaseBytes = size_t{64} << 10;

// Empty unless the digits are a case's whole encoding: a file that was cut off is none.
[[nodiscard]] std::optional<spec::Case> case_of(std::string_view digits) {
  const std::optional<spec::Case> found = spec::from_hex(digits);
  return found && spec::to_hex(*found) == digits ? found : std::nullopt;
}

// One line: the law's name, a blank, the case in hexadecimal.
[[nodiscard]] KnownCase read_known(const std::filesystem::path& path) {
  std::string text = read_text_file(path, kMaxFileOfCaseBytes);
  while (text.ends_with('\n') || text.ends_with('\r')) text.pop_back();
  const std::vector<std::string_view> words = split(text, ' ');
  const std::optional<spec::Case> found = words.size() == 2 ? case_of(words[1]) : std::nullopt;
  if (found && !spec::is_law_name(words[0])) {
    throw UserError("'" + path.string() + "': no law is called '" + std::string(words[0]) +
                    "'; 'selvage laws' lists them");
  }
  if (!found) {
    throw UserError("'" + path.string() +
                    "' is no known violation: one line is right, a law's name, a blank and the "
                    "case's hexadecimal digits as verify prints them");
  }
  return {std::string(words[0]), *found};
}

// FNV-1a, 64 bits (Fowler, Noll, Vo).
[[nodiscard]] uint64_t hash_of(std::string_view text) {
  uint64_t hash = 0xCBF29CE484222325U;
  for (const char letter : text) hash = (hash ^ static_cast<uint8_t>(letter)) * 0x100000001B3U;
  return hash;
}

[[nodiscard]] std::filesystem::path without_slash(const std::filesystem::path& directory) {
  return directory.has_filename() ? directory : directory.parent_path();
}

}  // namespace

void check_corpus(const std::filesystem::path& directory) {
  const std::filesystem::path above =
      without_slash(directory).has_parent_path() ? without_slash(directory).parent_path() : ".";
  std::error_code error;
  if (!std::filesystem::is_directory(above, error)) {
    throw UserError("--corpus: cannot make '" + directory.string() + "': there is no directory '" +
                    above.string() + "'");
  }
}

void make_corpus(const std::filesystem::path& directory, const Console& console) {
  check_corpus(directory);
  const std::filesystem::path named = without_slash(directory);
  std::error_code error;
  const bool is_made = std::filesystem::create_directory(named, error);
  if (!std::filesystem::is_directory(named, error)) {
    throw UserError("--corpus: '" + directory.string() +
                    "' is no directory and cannot be made one");
  }
  if (is_made) console.err << "selvage: made the directory '" << named.string() << "'\n";
}

std::vector<KnownCase> read_corpus(const std::filesystem::path& directory) {
  std::error_code error;
  std::vector<std::filesystem::path> paths;
  std::filesystem::directory_iterator entry(directory, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    if (entry->path().extension() == ".case") paths.push_back(entry->path());
  }
  if (error) {
    throw UserError("--corpus: cannot read '" + directory.string() + "': " + error.message());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<KnownCase> known;
  for (const auto& path : paths) {
    if (!std::filesystem::is_regular_file(path, error)) {
      throw UserError("'" + path.string() + "' is no regular file; a corpus has no other *.case");
    }
    known.push_back(read_known(path));
  }
  return known;
}

std::string corpus_name(std::string_view law, const spec::Case& c) {
  char digits[20];
  const uint64_t hash = hash_of(std::string(law) + " " + spec::to_hex(c));
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return std::string(law) + "-" + digits + ".case";
}

void write_to_corpus(const std::filesystem::path& directory, const KnownCase& known) {
  write_text_file(directory / corpus_name(known.law, known.found),
                  known.law + " " + spec::to_hex(known.found) + "\n");
}

void add_to_corpus(const std::filesystem::path& directory, const VerifyRun& run) {
  if (directory.empty() || run.replay) return;
  for (const Verdict& verdict : run.verdicts) {
    if (!verdict.found.violation || verdict.from_corpus) continue;
    write_to_corpus(directory,
                    {std::string(verdict.found.law->name), *verdict.found.counterexample});
  }
}

}  // namespace selvage::cli
