// How many cases it takes to reject each wrong mapper of the catalogue: at random, and hunted.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coverage/wrong_mappers.h"
#include "spec/generate_historic.h"
#include "spec/hunt.h"

namespace selvage {
namespace {

struct Options {
  uint64_t seeds = 5, cases = 1500, first = 0;  // the place in the catalogue to begin at
  std::string_view only{};
};

// A wrong recipe asks the model for what it has not, and that throws: the mapper's crash.
[[nodiscard]] spec::Subject crashing_by_name(spec::Subject subject) {
  subject.draw = [draw = subject.draw](auto... arguments) {
    try {
      return draw(arguments...);
    } catch (const std::exception& error) {
      throw spec::SubjectFailure{.happened = std::string("threw: ") + error.what()};
    }
  };
  return subject;
}

// The number of the first case that is rejected, from 1 on; most + 1 if none is.
[[nodiscard]] uint64_t first_kill_at_random(const spec::Law& law, const spec::Subject& subject,
                                            uint64_t seed, uint64_t most) {
  for (uint64_t i = 0; i < most; ++i) {
    const spec::Case c = within(subject.claims, spec::generate(seed + i, subject.profile));
    if (judge(law, subject, c).violation) return i + 1;
  }
  return most + 1;
}

[[nodiscard]] uint64_t first_kill_by_hunting(const spec::Law& law, const spec::Subject& subject,
                                             uint64_t seed, uint64_t most) {
  uint64_t done = 0;
  for (uint64_t number = 0; done < most; ++number) {
    spec::Climb climb(law, subject, seed, number);
    for (uint64_t step = 0; step < spec::kClimbCases && done < most; ++step) {
      const spec::Case c = climb.propose();
      const spec::Judgement judgement = judge(law, subject, c);
      ++done;
      if (judgement.violation) return done;
      climb.weigh(c, score_of(law, c, judgement.margin));
    }
  }
  return most + 1;
}

[[nodiscard]] uint64_t median(std::vector<uint64_t> counts) {
  const auto middle = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2);
  std::ranges::nth_element(counts, middle);
  return *middle;
}

void measure(const coverage::WrongMapper& wrong, const Options& options) {
  const spec::Law* law = spec::find_law(wrong.killer);
  if (law == nullptr) return;
  const spec::Subject subject = crashing_by_name(wrong.subject);
  std::vector<uint64_t> random, hunted;
  for (uint64_t i = 0; i < options.seeds; ++i) {
    const uint64_t seed = 1 + 1'000'000 * i;
    random.push_back(first_kill_at_random(*law, subject, seed, options.cases));
    hunted.push_back(first_kill_by_hunting(*law, subject, seed, options.cases));
  }
  std::printf("%-40s %-10s %8llu %8llu\n", wrong.name.c_str(), wrong.killer.data(),
              static_cast<unsigned long long>(median(random)),
              static_cast<unsigned long long>(median(hunted)));
  std::fflush(stdout);
}

}  // namespace
}  // namespace selvage

int main(int count, char** words) {
  selvage::Options options;
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string_view option = words[i];
    if (option == "--seeds") options.seeds = std::strtoull(words[i + 1], nullptr, 10);
    if (option == "--cases") options.cases = std::strtoull(words[i + 1], nullptr, 10);
    if (option == "--first") options.first = std::strtoull(words[i + 1], nullptr, 10);
    if (option == "--only") options.only = words[i + 1];
  }
  for (const auto& wrong : selvage::coverage::wrong_mappers().subspan(options.first)) {
    if (wrong.name.find(options.only) != std::string::npos) selvage::measure(wrong, options);
  }
}
