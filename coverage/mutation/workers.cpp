#include "coverage/mutation/workers.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace selvage::mutation {
namespace {

// Neighbours die of the same: a worker takes some in a row.
inline constexpr size_t kInARow = 8;

using Next = std::atomic<size_t>;
static_assert(Next::is_always_lock_free);  // it is shared by processes

[[nodiscard]] std::string line_of(size_t index, const Outcome& outcome) {
  std::ostringstream line;
  line << index << '\t' << outcome.what << '\t' << outcome.killer << '\t' << outcome.on << '\t'
       << outcome.tried << '\n';
  return line.str();
}

struct Told {
  size_t index = 0;
  Outcome outcome{};
};

[[nodiscard]] Told told_by(const std::string& line) {
  std::istringstream words(line);
  std::string index, tried;
  Told told;
  std::getline(words, index, '\t');
  std::getline(words, told.outcome.what, '\t');
  std::getline(words, told.outcome.killer, '\t');
  std::getline(words, told.outcome.on, '\t');
  std::getline(words, tried);
  told.index = std::stoul(index);
  told.outcome.tried = std::stoul(tried);
  return told;
}

// A line is written at once, so that lines of workers do not mix (pipe(7): up to PIPE_BUF bytes).
void work(const std::vector<Mutant>& mutants, Trials trials, const Store& store, Next* next,
          int results) {
  for (size_t first; (first = next->fetch_add(kInARow)) < mutants.size();) {
    for (size_t i = first; i < std::min(first + kInARow, mutants.size()); ++i) {
      const std::string line = line_of(i, trials.of(mutants[i], store.killer_of(mutants[i])));
      const bool fits = line.size() <= PIPE_BUF;
      if (!fits || write(results, line.data(), line.size()) < 0) _exit(1);
    }
  }
}

// Reads what the workers tell until the last of them ends; how many mutants there were.
[[nodiscard]] size_t collect(int results, const std::vector<Mutant>& mutants, Store* store,
                             const std::function<void(size_t done, size_t alive)>& tell) {
  std::FILE* const lines = fdopen(results, "r");
  char* text = nullptr;
  size_t room = 0, done = 0, alive = 0;
  while (getline(&text, &room, lines) > 0) {
    const Told told = told_by(text);
    store->add(mutants[told.index], told.outcome);
    alive += told.outcome.lived() ? 1 : 0;
    tell(++done, alive);
  }
  std::free(text);
  std::fclose(lines);
  return done;
}

[[nodiscard]] bool all_ended_well(const std::vector<pid_t>& workers) {
  bool well = true;
  for (const pid_t worker : workers) {
    int status = 0;
    well &= waitpid(worker, &status, 0) == worker && status == 0;
  }
  return well;
}

}  // namespace

void try_all(const std::vector<Mutant>& mutants, int jobs, const Trials& trials, Store* store,
             const std::function<void(size_t done, size_t alive)>& tell) {
  void* const memory =
      mmap(nullptr, sizeof(Next), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::runtime_error("no shared memory: mmap failed");
  Next* const next = new (memory) Next{0};
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe for the workers");
  std::vector<pid_t> workers;
  std::fflush(nullptr);
  for (int k = 0; k < jobs; ++k) {
    const pid_t worker = fork();
    if (worker == 0) {
      close(ends[0]);
      work(mutants, trials, *store, next, ends[1]);
      _exit(0);
    }
    if (worker > 0) workers.push_back(worker);  // if there is no process for it, others do its work
  }
  close(ends[1]);
  const size_t done = collect(ends[0], mutants, store, tell);
  munmap(memory, sizeof(Next));
  if (!all_ended_well(workers) || done != mutants.size()) {
    throw std::runtime_error("a worker ended before its work; what was done is kept: run it again");
  }
}

}  // namespace selvage::mutation
