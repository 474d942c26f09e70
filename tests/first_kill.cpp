#include "first_kill.h"

#include <algorithm>
#include <exception>
#include <string>
#include <utility>

#include "coverage/recipe.h"
#include "spec/generate_historic.h"
#include "spec/hunt.h"

namespace selvage::test {
namespace {

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

[[nodiscard]] uint64_t median(std::vector<uint64_t> counts) {
  const auto middle = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2);
  std::ranges::nth_element(counts, middle);
  return *middle;
}

[[nodiscard]] spec::Rational rounded(const spec::Rational& value, unsigned bits) {
  const spec::Rational unit(1, int64_t{1} << bits);
  const spec::Rational off = value / unit - spec::Rational(1, 2);
  mpz_class units;
  mpz_cdiv_q(units.get_mpz_t(), off.get_num_mpz_t(), off.get_den_mpz_t());
  return spec::Rational(units) * unit;
}

}  // namespace

uint64_t first_kill_at_random(const spec::Law& law, const spec::Subject& subject, uint64_t seed,
                              uint64_t most) {
  for (uint64_t i = 0; i < most; ++i) {
    const spec::Case c = within(subject.claims, spec::generate(seed + i, subject.profile));
    if (judge(law, subject, c).violation) return i + 1;
  }
  return most + 1;
}

uint64_t first_kill_by_hunting(const spec::Law& law, const spec::Subject& subject, uint64_t seed,
                               uint64_t most) {
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

Gain gain_of(const spec::Law& law, const spec::Subject& subject, uint64_t seeds, uint64_t most) {
  const spec::Subject crashing = crashing_by_name(subject);
  std::vector<uint64_t> random, hunted;
  for (uint64_t i = 0; i < seeds; ++i) {
    const uint64_t seed = 1 + 1'000'000 * i;
    random.push_back(first_kill_at_random(law, crashing, seed, most));
    hunted.push_back(first_kill_by_hunting(law, crashing, seed, most));
  }
  return {median(std::move(random)), median(std::move(hunted))};
}

spec::Subject coordinates_of(unsigned bits) {
  coverage::Recipe recipe;
  recipe.map = [bits](const coverage::Job&, const spec::ScanLine& line, const spec::Rational& x) {
    const spec::Sample point = coverage::Recipe::interpolate(line, x);
    return spec::Sample{rounded(point.u, bits), rounded(point.v, bits)};
  };
  return subject_of("u_v_of_" + std::to_string(bits) + "_bits", std::move(recipe));
}

spec::Subject edges_of(unsigned bits) {
  coverage::Recipe recipe;
  recipe.covers = [bits](const spec::ScanLine& line, const spec::Rational& x) {
    return rounded(line.left.x, bits) <= x && x < rounded(line.right.x, bits);
  };
  return subject_of("edges_of_" + std::to_string(bits) + "_bits", std::move(recipe));
}

spec::Subject weights_of(unsigned bits) {
  coverage::Recipe recipe;
  recipe.taps = [bits](selvage_filter filter, const spec::Rational& u, int32_t side_fx8) {
    return spec::taps(filter, rounded(u, bits), side_fx8);
  };
  return subject_of("filtered_u_v_of_" + std::to_string(bits) + "_bits", std::move(recipe));
}

}  // namespace selvage::test
