// Gappa's word on a script.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

namespace selvage {

struct Verdict {
  int status;  // Gappa's exit status, or -1
  std::string output;
};

[[nodiscard]] inline Verdict ask_gappa(const std::string& program, const std::string& text) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) /
                                     ("selvage_proof_" + std::to_string(getpid()) + ".g");
  std::ofstream(path) << text;
  const std::string command = "'" + program + "' '" + path.string() + "' 2>&1";
  Verdict verdict{-1, ""};
  if (FILE* pipe = popen(command.c_str(), "r")) {
    std::array<char, 4096> piece{};
    while (fgets(piece.data(), piece.size(), pipe) != nullptr) verdict.output += piece.data();
    const int status = pclose(pipe);
    if (WIFEXITED(status)) verdict.status = WEXITSTATUS(status);
  }
  std::filesystem::remove(path);
  return verdict;
}

}  // namespace selvage
