#include "coverage/matrix/matrix.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>

#include "spec/capabilities.h"
#include "spec/generate_historic.h"
#include "spec/profiles.h"
#include "spec/verify.h"

namespace selvage::coverage {

namespace {

// No mapper of the catalogue may make a law throw: that is a mistake in one of the two.
[[nodiscard]] spec::Judgement judge_or_tell(const spec::Law& law, const WrongMapper& wrong,
                                            const spec::Case& c) {
  try {
    return spec::judge(law, wrong.subject, c);
  } catch (const std::exception& error) {
    throw std::runtime_error(std::string(law.name) + " with " + wrong.name + ": " + error.what() +
                             ", on case " + spec::to_hex(c));
  }
}

}  // namespace

Cell try_law(const spec::Law& law, const WrongMapper& wrong, Budget budget) {
  const spec::Subject& subject = wrong.subject;
  if (!spec::is_promised(subject.profile, law.name)) return {};
  const bool is_killer = law.name == wrong.killer;
  const uint64_t cases = is_killer ? std::max(budget.cases, budget.killer_cases) : budget.cases;
  uint64_t judged_px = 0;
  for (uint64_t i = 0; i < cases; ++i) {
    const spec::Case c =
        spec::within(subject.claims, spec::generate(budget.first_seed + i, subject.profile));
    const spec::Judgement judgement = judge_or_tell(law, wrong, c);
    if (judgement.violation) return {Fate::kKilled, i + 1};
    judged_px += judgement.judged_px;
  }
  return {judged_px > 0 ? Fate::kPassed : Fate::kNotJudged, cases};
}

Matrix fill(std::vector<const WrongMapper*> mappers, Budget budget, unsigned threads,
            const std::function<void(size_t, size_t)>& progress) {
  const size_t law_count = spec::laws().size(), all = mappers.size() * law_count;
  Matrix matrix{budget, {}};
  for (const WrongMapper* mapper : mappers) matrix.rows.push_back({mapper, {}});
  for (Row& row : matrix.rows) row.cells.resize(law_count);
  std::atomic<size_t> next = 0;
  std::mutex telling;
  size_t done = 0;
  std::exception_ptr trouble;
  const auto fill_cell = [&](size_t i) {
    Row& row = matrix.rows[i / law_count];
    row.cells[i % law_count] = try_law(spec::laws()[i % law_count], *row.mapper, budget);
    const std::lock_guard lock(telling);
    ++done;
    if (progress) progress(done, all);
  };
  const auto work = [&] {
    try {
      for (size_t i = next++; i < all; i = next++) fill_cell(i);
    } catch (...) {
      next = all;
      const std::lock_guard lock(telling);
      trouble = std::current_exception();
    }
  };
  std::vector<std::jthread> workers;
  for (unsigned i = 1; i < threads; ++i) workers.emplace_back(work);
  work();
  workers.clear();
  if (trouble) std::rethrow_exception(trouble);
  return matrix;
}

size_t kills_of(const Row& row) {
  return static_cast<size_t>(std::ranges::count(row.cells, Fate::kKilled, &Cell::fate));
}

Tally tally(const Matrix& matrix, size_t law) {
  Tally result;
  for (const Row& row : matrix.rows) {
    const Fate fate = row.cells[law].fate;
    result.promised += fate != Fate::kNotPromised ? 1 : 0;
    if (fate != Fate::kKilled) continue;
    ++result.kills;
    result.sole += kills_of(row) == 1 ? 1 : 0;
  }
  return result;
}

}  // namespace selvage::coverage
