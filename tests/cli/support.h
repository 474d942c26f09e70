// What the tests of the program share: a directory of their own, and the text of errors.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "cli/error.h"
#include "cli/raster.h"
#include "tests/temporary_folder.h"

namespace selvage::cli::test {

// The message of the UserError that `action` throws; empty, and a failure, if it throws none.
template <typename Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const UserError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no UserError was thrown";
  return {};
}

inline void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "no '" << part << "' in: " << text;
}

// A test in an empty directory, which is the current one while it runs.
class InDirectory : public testing::Test {
 protected:
  InDirectory() : before_(std::filesystem::current_path()) {
    std::filesystem::current_path(folder_.path());
  }
  ~InDirectory() override { std::filesystem::current_path(before_); }

  // The names of what lies in the directory, temporary files included.
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  TemporaryFolder folder_;
  std::filesystem::path before_;
};

inline void put(const std::string& name, std::span<const uint8_t> bytes) {
  std::ofstream file(name, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

inline void put(const std::string& name, const std::string& text) {
  put(name, std::span(reinterpret_cast<const uint8_t*>(text.data()), text.size()));
}

[[nodiscard]] inline std::string get(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace selvage::cli::test
