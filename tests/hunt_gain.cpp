// How many cases it takes to reject each wrong mapper of the catalogue: at random, and hunted.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coverage/recipe.h"
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

// Besides the catalogue: u and v rounded to 2^-bits texel, which is wrong where they are a
// hair off a texel's border, and seldom anywhere.
[[nodiscard]] spec::Subject of_few_bits(unsigned bits) {
  coverage::Recipe recipe;
  recipe.map = [bits](const coverage::Job&, const spec::ScanLine& line, const spec::Rational& x) {
    const auto rounded = [bits](const spec::Rational& u) {
      const spec::Rational unit(1, int64_t{1} << bits);
      spec::Rational off = u / unit - spec::Rational(1, 2);
      mpz_class units;
      mpz_cdiv_q(units.get_mpz_t(), off.get_num_mpz_t(), off.get_den_mpz_t());
      return spec::Rational(units * unit);
    };
    const spec::Sample point = coverage::Recipe::interpolate(line, x);
    return spec::Sample{rounded(point.u), rounded(point.v)};
  };
  return subject_of("u_v_of_" + std::to_string(bits) + "_bits", std::move(recipe));
}

void measure(const spec::Subject& wrong, std::string_view killer, const Options& options) {
  const spec::Law* law = spec::find_law(killer);
  if (law == nullptr || wrong.name.find(options.only) == std::string::npos) return;
  const spec::Subject subject = crashing_by_name(wrong);
  std::vector<uint64_t> random, hunted;
  for (uint64_t i = 0; i < options.seeds; ++i) {
    const uint64_t seed = 1 + 1'000'000 * i;
    random.push_back(first_kill_at_random(*law, subject, seed, options.cases));
    hunted.push_back(first_kill_by_hunting(*law, subject, seed, options.cases));
  }
  std::printf("%-40s %-10s %8llu %8llu\n", wrong.name.c_str(), law->name.data(),
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
    selvage::measure(wrong.subject, wrong.killer, options);
  }
  for (const unsigned bits : {8U, 12U, 16U, 20U, 24U, 28U, 32U}) {
    selvage::measure(selvage::of_few_bits(bits), "MAP", options);
  }
}
