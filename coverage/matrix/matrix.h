// The matrix of wrong mappers and laws: which law kills which, and after how many cases.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "coverage/wrong_mappers.h"
#include "spec/laws.h"

namespace selvage::coverage {

enum class Fate {
  kKilled,
  kPassed,      // the law judged it and saw nothing wrong within the budget
  kNotJudged,   // the law found nothing to judge
  kNotPromised  // the profile does not promise the law: a right mapper may break it too
};

struct Cell {
  Fate fate = Fate::kNotPromised;
  uint64_t cases = 0;  // looked at, the one that kills included
};

// Of one law against one mapper.
struct Budget {
  uint64_t first_seed = 1;
  uint64_t cases = 20;
  // Of the law that the catalogue names, if that is more: as many as the tests give it.
  uint64_t killer_cases = kKillerCases;
};

struct Row {
  const WrongMapper* mapper = nullptr;
  std::vector<Cell> cells;  // in the order of spec::laws()
};

struct Matrix {
  Budget budget;
  std::vector<Row> rows;
};

// Without shrinking.
[[nodiscard]] Cell try_law(const spec::Law& law, const WrongMapper& wrong, Budget budget);

// Some mappers against all laws, by so many threads. `progress` is told the cells done, now and
// then, by one thread at a time; may be empty.
[[nodiscard]] Matrix fill(std::vector<const WrongMapper*> mappers, Budget budget, unsigned threads,
                          const std::function<void(size_t done, size_t all)>& progress = {});

[[nodiscard]] size_t kills_of(const Row& row);

// Of one law, over all mappers.
struct Tally {
  size_t promised = 0, kills = 0;
  size_t sole = 0;  // mappers that no other law kills
};
[[nodiscard]] Tally tally(const Matrix& matrix, size_t law);

}  // namespace selvage::coverage
