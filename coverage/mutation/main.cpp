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
#include <vector>

#include "coverage/mutation/trial.h"
#include "spec/random.h"

namespace selvage::mutation {
namespace {

struct Options {
  std::string sites, results, key;
  uint64_t seeds = 300, first_seed = 1, sample_seed = 1;
  size_t sample = 0;
  double most_s = 1e9;
  std::vector<int> only;
};

[[nodiscard]] std::vector<Mutant> read_mutants(const std::string& path) {
  std::ifstream file(path);
  std::vector<Mutant> mutants;
  for (Mutant m; file >> m.number >> m.site;) mutants.push_back(m);
  if (mutants.empty()) throw std::runtime_error(path + " holds no mutants: run coverage/mutants");
  return mutants;
}

// Some of them, each as likely as any other, in their order.
[[nodiscard]] std::vector<Mutant> sampled(std::vector<Mutant> mutants, size_t count,
                                          uint64_t seed) {
  spec::Random random(seed);
  std::vector<Mutant> chosen;
  size_t left = mutants.size();
  for (const Mutant& m : mutants) {
    if (random.below(left--) < count - chosen.size()) chosen.push_back(m);
  }
  return chosen;
}

// The mutants that an earlier run with the same key has been through.
[[nodiscard]] std::map<int, bool> done_before(const std::string& path, const std::string& key) {
  std::map<int, bool> done;
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line) || line != key) return {};
  while (std::getline(file, line)) done[std::stoi(line)] = true;
  return done;
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
  if (options.sample > 0) mutants = sampled(mutants, options.sample, options.sample_seed);
  const auto start = std::chrono::steady_clock::now();
  const auto since_s = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const bool terminal = isatty(STDERR_FILENO) != 0;
  silence_stdout();
  std::vector<Item> items = all_items(options.first_seed, options.seeds);
  const std::vector<std::string> broken = record(&items, options.most_s);
  for (const std::string& name : broken) {
    std::cerr << "broken although nothing is mutated: " << name << "\n";
  }
  if (!broken.empty()) return 2;
  double cost_s = 0;
  for (const Item& item : items) cost_s += item.cost_s;
  std::cerr << items.size() << " items, " << cost_s << " s of processor time without a mutant\n";

  const std::map<int, bool> done = done_before(options.results, options.key);
  std::ofstream results(options.results, done.empty() ? std::ios::trunc : std::ios::app);
  if (done.empty()) results << options.key << "\n";
  size_t count = 0, alive = 0;
  for (const Mutant& mutant : mutants) {
    ++count;
    if (done.contains(mutant.number)) continue;
    const Outcome outcome = try_mutant(mutant, items);
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
  app.add_option("--cases", options.seeds, "generated cases for each law");
  app.add_option("--first-seed", options.first_seed, "of these cases");
  app.add_option("--sample", options.sample, "so many mutants, chosen at random");
  app.add_option("--seed", options.sample_seed, "of that choice");
  app.add_option("--most-seconds", options.most_s, "what costs more, unmutated, is left out");
  app.add_option("--mutant", options.only, "only these numbers");
  CLI11_PARSE(app, argc, argv);
  try {
    return selvage::mutation::run(options);
  } catch (const std::exception& error) {
    std::cerr << "mutants: " << error.what() << "\n";
    return 2;
  }
}
