// Tries mutants one after another and writes a line for each.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "coverage/mutation/trial.h"

namespace selvage::mutation {
namespace {

struct Options {
  std::string sites, results, key;
  uint64_t seeds = 300, first_seed = 1;
  double most_s = 1e6, each_s = 1e6;
  bool again = false;
  std::vector<int> only;
};

[[nodiscard]] std::vector<Mutant> read_mutants(const std::string& path) {
  std::ifstream file(path);
  std::vector<Mutant> mutants;
  for (Mutant m; file >> m.number >> m.site;) mutants.push_back(m);
  if (mutants.empty()) throw std::runtime_error(path + " holds no mutants: run coverage/mutants");
  return mutants;
}

[[nodiscard]] std::string first_word(const std::string& line) {
  return line.substr(0, line.find(' '));
}

// Lines of an earlier run that hold still, by their mutants: all of a run with the same key. Of one
// whose key begins alike, if only the survivors are to be tried again, those of the others.
[[nodiscard]] std::map<int, std::string> kept_lines(const Options& options) {
  std::map<int, std::string> kept;
  std::ifstream file(options.results);
  std::string line;
  if (!std::getline(file, line) || first_word(line) != first_word(options.key)) return {};
  const bool same = line == options.key;
  if (!same && !options.again) return {};
  while (std::getline(file, line)) {
    const bool alive = line.find("\tsurvived\t") != std::string::npos ||
                       line.find("\tnot reached\t") != std::string::npos;
    if (!alive || (same && !options.again)) kept[std::stoi(line)] = line;
  }
  return kept;
}

// The unit tests talk; nobody listens.
void silence_stdout() {
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  close(nowhere);
}

void tell(size_t done, size_t all, size_t left_alive, double since_s) {
  std::fprintf(stderr, "\r%zu of %zu mutants, %zu not killed, %.0f s ", done, all, left_alive,
               since_s);
}

int run(const Options& options) {
  std::vector<Mutant> mutants = read_mutants(options.sites);
  if (!options.only.empty()) {
    std::erase_if(mutants, [&](const Mutant& m) {
      return std::ranges::find(options.only, m.number) == options.only.end();
    });
  }
  const auto start = std::chrono::steady_clock::now();
  const auto since_s = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const bool terminal = isatty(STDERR_FILENO) != 0;
  silence_stdout();
  std::vector<Item> items = all_items(options.first_seed, options.seeds);
  const size_t all = items.size();
  const std::vector<std::string> broken = record(&items, options.most_s);
  for (const std::string& name : broken) {
    std::cerr << "broken although nothing is mutated: " << name << "\n";
  }
  if (!broken.empty()) return 2;
  double cost_s = 0;
  for (const Item& item : items) cost_s += item.cost_s;
  std::cerr << items.size() << " items, " << cost_s << " s of processor time without a mutant; "
            << all - items.size() << " more cost above " << options.most_s << " s each\n";

  const std::map<int, std::string> done = kept_lines(options);
  std::ofstream results(options.results);
  results << options.key << "\n";
  for (const auto& [number, line] : done) results << line << "\n";
  Trials trials(std::move(items), options.each_s);
  size_t count = 0, alive = 0;
  for (const Mutant& mutant : mutants) {
    ++count;
    if (done.contains(mutant.number)) continue;
    const Outcome outcome = trials.of(mutant);
    alive += outcome.what == "survived" || outcome.what == "not reached" ? 1 : 0;
    results << mutant.number << "\t" << outcome.what << "\t" << outcome.killer << "\t" << outcome.on
            << "\t" << outcome.tried << std::endl;
    if (terminal) tell(count, mutants.size(), alive, since_s());
  }
  if (terminal) std::fputc('\n', stderr);
  return results ? 0 : 2;
}

}  // namespace
}  // namespace selvage::mutation

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  selvage::mutation::Options options;
  CLI::App app("Tries the mutants of this program; called by coverage/mutants.");
  app.add_option("--sites", options.sites, "the list of mutants")->required();
  app.add_option("--results", options.results, "where a line for each is added")->required();
  app.add_option("--key", options.key, "results under another key are begun anew");
  app.add_flag("--again", options.again,
               "the survivors of results whose key has the same first word");
  app.add_option("--cases", options.seeds, "generated cases for each law");
  app.add_option("--first-seed", options.first_seed, "of these cases");
  app.add_option("--most-seconds", options.most_s, "what costs more, unmutated, is left out");
  app.add_option("--seconds-each", options.each_s, "of processor time for a mutant");
  app.add_option("--mutant", options.only, "only these numbers");
  CLI11_PARSE(app, argc, argv);
  try {
    return selvage::mutation::run(options);
  } catch (const std::exception& error) {
    std::cerr << "mutants: " << error.what() << "\n";
    return 2;
  }
}
