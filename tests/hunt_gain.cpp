// How many cases it takes to reject each wrong mapper of the catalogue: at random, and hunted.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "coverage/wrong_mappers.h"
#include "first_kill.h"

namespace selvage::test {
namespace {

struct Options {
  uint64_t seeds = 5, cases = 1000, first = 0;  // the place in the catalogue to begin at
  std::string_view only{};
};

// How often hunting took fewer cases, as many, or more.
struct Count {
  int fewer = 0, as_many = 0, more = 0;
};

void measure(const spec::Subject& wrong, std::string_view killer, const Options& options,
             Count* count) {
  const spec::Law* law = spec::find_law(killer);
  if (law == nullptr || wrong.name.find(options.only) == std::string::npos) return;
  const Gain gain = gain_of(*law, wrong, options.seeds, options.cases);
  ++(gain.hunted < gain.random    ? count->fewer
     : gain.hunted == gain.random ? count->as_many
                                  : count->more);
  std::printf("%-40s %-10s %8llu %8llu\n", wrong.name.c_str(), law->name.data(),
              static_cast<unsigned long long>(gain.random),
              static_cast<unsigned long long>(gain.hunted));
  std::fflush(stdout);
}

void measure_all(const Options& options) {
  Count count, small;
  for (const auto& wrong : coverage::wrong_mappers().subspan(options.first)) {
    measure(wrong.subject, wrong.killer, options, &count);
  }
  for (const unsigned bits : {12U, 16U, 20U, 24U, 28U}) {
    measure(edges_of(bits), "COV", options, &small);
    measure(coordinates_of(bits), "MAP", options, &small);
    measure(weights_of(bits), "FILTER", options, &small);
  }
  std::printf("catalogue: hunting took fewer cases for %d, as many for %d, more for %d\n",
              count.fewer, count.as_many, count.more);
  std::printf("small errors: fewer for %d, as many for %d, more for %d\n", small.fewer,
              small.as_many, small.more);
}

}  // namespace
}  // namespace selvage::test

int main(int count, char** words) {
  selvage::test::Options options;
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string_view option = words[i];
    if (option == "--seeds") options.seeds = std::strtoull(words[i + 1], nullptr, 10);
    if (option == "--cases") options.cases = std::strtoull(words[i + 1], nullptr, 10);
    if (option == "--first") options.first = std::strtoull(words[i + 1], nullptr, 10);
    if (option == "--only") options.only = words[i + 1];
  }
  selvage::test::measure_all(options);
}
