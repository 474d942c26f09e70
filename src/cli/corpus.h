// Known violations, a file each: what was found once is tried first ever after, on every subject.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "cli/verdict.h"
#include "spec/case.h"

namespace selvage::cli {

struct KnownCase {
  std::string law;
  spec::Case found;
};

// All of the directory's *.case files, which must be regular ones, in the order of their names. The
// directory is made if it is not there. Throws UserError, which names the file, where one holds
// anything else.
[[nodiscard]] std::vector<KnownCase> read_corpus(const std::filesystem::path& directory);

// "MAP-0123456789abcdef.case": the same for the same law and case.
[[nodiscard]] std::string corpus_name(std::string_view law, const spec::Case& c);
void write_to_corpus(const std::filesystem::path& directory, const KnownCase& known);
// The violations of a run that were not known before; nothing of a replay, nor where the directory
// is empty.
void add_to_corpus(const std::filesystem::path& directory, const VerifyRun& run);

}  // namespace selvage::cli
