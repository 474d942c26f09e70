// Tries mutants and writes a line for each.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "coverage/mutation/store.h"
#include "coverage/mutation/trial.h"
#include "coverage/mutation/workers.h"

namespace selvage::mutation {
namespace {

struct Options {
  std::string sites, store, outcomes;
  Made made;
  uint64_t seeds = 300, first_seed = 1;
  double most_s = 1e6, each_s = 1e6;
  int jobs = 1;
  bool again = false;
  std::vector<int> only;
  std::vector<std::string> in;

  [[nodiscard]] bool wants(const Mutant& m) const {
    const auto has = [&](const std::string& part) { return m.path.find(part) != m.path.npos; };
    return (only.empty() || std::ranges::find(only, m.number) != only.end()) &&
           (in.empty() || std::ranges::any_of(in, has));
  }
};

[[nodiscard]] std::vector<Mutant> read_mutants(const std::string& path) {
  std::ifstream file(path);
  std::vector<Mutant> mutants;
  for (Mutant m; file >> m.number >> m.site >> m.name >> m.text >> m.path;) mutants.push_back(m);
  if (mutants.empty()) throw std::runtime_error(path + " holds no mutants: run coverage/mutants");
  return mutants;
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

// All items that hold for the program as it is; none if one is broken.
[[nodiscard]] std::vector<Item> recorded_items(const Options& options) {
  std::vector<Item> items = all_items(options.first_seed, options.seeds);
  const size_t all = items.size();
  const std::vector<std::string> broken = record(&items, options.most_s);
  for (const std::string& name : broken) {
    std::cerr << "broken although nothing is mutated: " << name << "\n";
  }
  if (!broken.empty()) return {};
  double cost_s = 0;
  for (const Item& item : items) cost_s += item.cost_s;
  std::cerr << items.size() << " items, " << cost_s << " s of processor time without a mutant; "
            << all - items.size() << " more cost above " << options.most_s << " s each\n";
  return items;
}

int run(const Options& options) {
  const std::vector<Mutant> mutants = read_mutants(options.sites);
  Store store(options.store, options.made, mutants);
  std::vector<Mutant> to_try;
  std::ranges::copy_if(mutants, std::back_inserter(to_try), [&](const Mutant& mutant) {
    const Outcome* const held = store.held(mutant);
    const bool anew = !options.only.empty() || (options.again && held != nullptr && held->lived());
    return options.wants(mutant) && (held == nullptr || anew);
  });
  if (!to_try.empty()) {
    silence_stdout();
    std::vector<Item> items = recorded_items(options);
    if (items.empty()) return 2;
    const bool terminal = isatty(STDERR_FILENO) != 0;
    const auto start = std::chrono::steady_clock::now();
    const Trials trials(std::move(items), options.each_s);
    try_all(to_try, options.jobs, trials, &store, [&](size_t done, size_t alive) {
      const std::chrono::duration<double> since_s = std::chrono::steady_clock::now() - start;
      if (terminal) tell(done, to_try.size(), alive, since_s.count());
    });
    if (terminal) std::fputc('\n', stderr);
  }
  std::ofstream outcomes(options.outcomes);
  for (const Mutant& mutant : mutants) {
    const Outcome* const held = store.held(mutant);
    if (held == nullptr || !options.wants(mutant)) continue;
    outcomes << mutant.number << "\t" << held->what << "\t" << held->killer << "\t" << held->on
             << "\t" << held->tried << "\n";
  }
  return store.is_good() && outcomes.flush() ? 0 : 2;
}

}  // namespace
}  // namespace selvage::mutation

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  selvage::mutation::Options options;
  CLI::App app("Tries the mutants of this program; called by coverage/mutants.");
  app.add_option("--sites", options.sites, "the list of mutants")->required();
  app.add_option("--store", options.store, "what mutants came to, in earlier runs too")->required();
  app.add_option("--outcomes", options.outcomes, "where what holds now is listed")->required();
  app.add_option("--program", options.made.program, "a hash of all there is")->required();
  app.add_option("--judges", options.made.judges, "a hash of all but the mapper")->required();
  app.add_flag("--again", options.again, "survivors anew");
  app.add_option("--cases", options.seeds, "generated cases for each law");
  app.add_option("--first-seed", options.first_seed, "of these cases");
  app.add_option("--most-seconds", options.most_s, "what costs more, unmutated, is left out");
  app.add_option("--seconds-each", options.each_s, "of processor time for a mutant");
  app.add_option("--jobs", options.jobs, "so many side by side")->check(CLI::PositiveNumber);
  app.add_option("--mutant", options.only, "only these numbers, anew");
  app.add_option("--in", options.in, "only those in files whose path has one of these in it");
  CLI11_PARSE(app, argc, argv);
  try {
    return selvage::mutation::run(options);
  } catch (const std::exception& error) {
    std::cerr << "mutants: " << error.what() << "\n";
    return 2;
  }
}
