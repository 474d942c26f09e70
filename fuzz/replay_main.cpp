// A plain main for a fuzz target: runs each input once. No engine, so any compiler will do.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kUsage =
    "Usage: fuzz_TARGET FILE-OR-DIRECTORY...\n"
    "\n"
    "Runs the fuzz target once on each file, and on each file below each directory. A finding "
    "ends\n"
    "the program by a signal after an explanation; --help prints this text.\n"
    "\n"
    "Example: build/fuzz_laws fuzz/seeds/laws\n"
    "\n"
    "Exit status: 0 if at least one input ran and none is a finding, 2 on wrong use or an\n"
    "unreadable file.\n";

// The files named by the arguments, in an order that is the same everywhere.
std::vector<fs::path> files_of(int count, char** arguments) {
  std::vector<fs::path> files;
  for (int i = 1; i < count; ++i) {
    if (!fs::is_directory(arguments[i])) {
      files.emplace_back(arguments[i]);
      continue;
    }
    const size_t first = files.size();
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(arguments[i])) {
      if (entry.is_regular_file()) files.push_back(entry.path());
    }
    std::sort(files.begin() + static_cast<std::ptrdiff_t>(first), files.end());
  }
  return files;
}

int replay(const std::vector<fs::path>& files) {
  for (const fs::path& file : files) {
    std::ifstream in(file, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    if (!in.is_open() || in.bad()) {
      std::cerr << "cannot read " << file << ": give a file or a directory that can be read\n";
      return 2;
    }
    std::cerr << "replaying " << file.string() << '\n';  // the last line names the culprit
    LLVMFuzzerTestOneInput(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size());
  }
  std::cout << files.size() << " inputs replayed\n";
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count == 2 && std::string_view(arguments[1]) == "--help") {
    std::cout << kUsage;
    return 0;
  }
  try {
    const std::vector<fs::path> files = files_of(count, arguments);
    if (!files.empty()) return replay(files);
    std::cerr << "no input to replay: give at least one file\n\n" << kUsage;
  } catch (const fs::filesystem_error& error) {
    std::cerr << error.what() << '\n';
  }
  return 2;
}
