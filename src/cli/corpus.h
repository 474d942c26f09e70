// Known violations, a file each: what was found once is tried first ever after, on every subject.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "cli/console.h"
#include "cli/verdict.h"
#include "spec/case.h"

namespace selvage::cli {

struct KnownCase {
  std::string law;
  spec::Case found;
};

// That the directory is there, or could be made in one that is: a mistyped path is an error. Throws
// UserError.
void check_corpus(const std::filesystem::path& directory);
// Makes it if it is not there, and tells console.err if it does. Throws UserError.
void make_corpus(const std::filesystem::path& directory, const Console& console);

// All of the directory's *.case files, which must be regular ones, in the order of their names.
// Throws UserError, which names the file, where one holds anything else.
[[nodiscard]] std::vector<KnownCase> read_corpus(const std::filesystem::path& directory);

// "MAP-0123456789abcdef.case": the same for the same law and case.
[[nodiscard]] std::string corpus_name(std::string_view law, const spec::Case& c);
void write_to_corpus(const std::filesystem::path& directory, const KnownCase& known);
// The violations of a run that were not known before; nothing of a replay, nor where there is no
// directory.
void add_to_corpus(const std::filesystem::path& directory, const VerifyRun& run);

}  // namespace selvage::cli
