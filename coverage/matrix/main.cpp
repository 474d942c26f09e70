// Holds every wrong mapper of the catalogue against every law; called by coverage/killers.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "coverage/matrix/expected.h"
#include "coverage/matrix/render.h"

namespace selvage::coverage {
namespace {

struct Options {
  Budget budget;
  unsigned threads = 1;
  std::vector<std::string> mappers;
  std::string out, expected;
  bool json = false, write = false;

  // The table was made with these.
  [[nodiscard]] bool is_usual() const {
    return budget.first_seed == Budget{}.first_seed && budget.cases == Budget{}.cases;
  }
};

[[nodiscard]] std::vector<const WrongMapper*> chosen(const std::vector<std::string>& names) {
  std::vector<const WrongMapper*> mappers;
  for (const WrongMapper& wrong : wrong_mappers()) {
    if (names.empty() || std::ranges::count(names, wrong.name) > 0) mappers.push_back(&wrong);
  }
  for (const std::string& name : names) {
    if (std::ranges::count(wrong_mappers(), name, &WrongMapper::name) == 0) {
      throw std::runtime_error("no wrong mapper is called " + name +
                               "; without --mapper the table names them all");
    }
  }
  return mappers;
}

void write_file(const std::filesystem::path& path, const std::string& text) {
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
  std::ofstream file(path);
  file << text;
  if (!file.flush()) throw std::runtime_error(path.string() + " cannot be written");
}

[[nodiscard]] ExpectedKillers read_file(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + " cannot be read; --write makes it");
  try {
    return read_expected(file);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

// What is wrong with the catalogue, a sentence each.
[[nodiscard]] std::vector<std::string> faults(const Matrix& matrix, const Options& options) {
  std::vector<std::string> told;
  for (const Row& row : matrix.rows) {
    if (kills_of(row) == 0) told.push_back(row.mapper->name + " survives every law");
  }
  if (options.mappers.empty()) {
    for (size_t i = 0; i < spec::laws().size(); ++i) {
      if (tally(matrix, i).kills > 0) continue;
      told.push_back(std::string(spec::laws()[i].name) + " kills no wrong mapper");
    }
  }
  if (!options.is_usual() || options.write) return told;
  for (const std::string& change : differences(read_file(options.expected), matrix)) {
    told.push_back(change + ": coverage/killers --write renews the table");
  }
  return told;
}

int run(const Options& options) {
  if (options.write && (!options.mappers.empty() || !options.is_usual())) {
    throw std::runtime_error(
        "--write wants all mappers, and seed and cases as they are by themselves");
  }
  const bool terminal = isatty(STDERR_FILENO) != 0;
  const Matrix matrix =
      fill(chosen(options.mappers), options.budget, options.threads, [&](size_t done, size_t all) {
        if (terminal) std::fprintf(stderr, "\r%zu of %zu cells ", done, all);
      });
  if (terminal) std::fputc('\n', stderr);
  std::cout << (options.json ? json_text(matrix) : text_table(matrix));
  if (!options.out.empty()) {
    write_file(options.out + "/killers.json", json_text(matrix));
    write_file(options.out + "/killers.html", html_page(matrix));
  }
  if (options.write) write_file(options.expected, expected_text(matrix));
  const std::vector<std::string> told = faults(matrix, options);
  for (const std::string& fault : told) std::cerr << fault << "\n";
  return told.empty() ? 0 : 1;
}

}  // namespace
}  // namespace selvage::coverage

int main(int argc, char** argv) {
  selvage::coverage::Options options;
  CLI::App app("Holds every wrong mapper against every law; called by coverage/killers.");
  app.add_option("--cases", options.budget.cases, "cases of each law against each mapper")
      ->check(CLI::Range(1, 1000000));
  app.add_option("--seed", options.budget.first_seed, "of the first case");
  app.add_option("--jobs", options.threads, "threads")->check(CLI::Range(1, 1024))->take_last();
  app.add_option("--mapper", options.mappers, "only this one; may be repeated");
  app.add_option("--out", options.out, "where killers.json and killers.html are written");
  app.add_option("--expected", options.expected, "the table of expected killers")->required();
  app.add_flag("--json", options.json, "JSON on stdout instead of the table");
  app.add_flag("--write", options.write, "write the table of expected killers anew");
  try {
    app.parse(argc, argv);
    return selvage::coverage::run(options);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::cerr << "killers: " << error.what() << "\n";
    return 2;
  }
}
