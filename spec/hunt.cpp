#include "spec/hunt.h"

#include <algorithm>
#include <array>
#include <utility>

#include "spec/closeness.h"
#include "spec/generate_historic.h"
#include "spec/law_tools.h"

namespace selvage::spec {
namespace {

constexpr int kStarts = 4;
constexpr int kProposals = 2;

// Of different seeds and numbers the climbs have nothing in common.
[[nodiscard]] uint64_t seed_of(uint64_t seed, uint64_t number) {
  Random random(seed);
  return random.bits() + number;
}

[[nodiscard]] double closeness_to(Aim aim, const Case& c) {
  if (aim == Aim::kNothing) return 0;
  const Closeness near = closeness(c);
  constexpr double kMost = double{kPlaces} * kMostBits;
  if (aim == Aim::kEdges) return near.edges / kMost;
  if (aim == Aim::kTexels) return near.texels / kMost;
  return (near.edges + near.texels) / (2 * kMost);
}

// Only FILTER judges by the case's filter, and of nearest ones it says little.
[[nodiscard]] double closeness_to(const Law& law, const Case& c) {
  const Aim aim = aim_at(law.name);
  if (law.name != "FILTER") return closeness_to(aim, with_nearest(c));
  return c.filter != SELVAGE_FILTER_NEAREST ? closeness_to(aim, c) : 0;
}

}  // namespace

Aim aim_at(std::string_view law) {
  constexpr std::array<std::string_view, 3> kEdges = {"COV", "PART", "PINWHEEL"};
  constexpr std::array<std::string_view, 8> kTexels = {"VERT",   "MAP",    "DDA",       "GAMUT",
                                                       "AFFINE", "FILTER", "TOLERANCE", "ORACLE"};
  constexpr std::array<std::string_view, 4> kNothing = {"IDENTITY", "MEM", "TOTAL", "SAME"};
  if (std::ranges::find(kNothing, law) != kNothing.end()) return Aim::kNothing;
  if (std::ranges::find(kEdges, law) != kEdges.end()) return Aim::kEdges;
  return std::ranges::find(kTexels, law) != kTexels.end() ? Aim::kTexels : Aim::kBoth;
}

Score score_of(const Law& law, const Case& c, const std::optional<Margin>& margin) {
  return {margin ? margin->share() : 0, closeness_to(law, c)};
}

Climb::Climb(const Law& law, const Subject& subject, uint64_t seed, uint64_t number)
    : law_(law), subject_(subject), random_(seed_of(seed, number)) {}

Case Climb::generated() {
  return within(subject_.claims, generate(random_.bits(), subject_.profile));
}

template <typename Make>
Case Climb::closest_of(int count, Make make) {
  std::pair<double, Case> closest{-1, {}};
  for (int i = 0; i < count; ++i) {
    Case c = make();
    const double closeness = closeness_to(law_, c);
    if (closeness > closest.first) closest = {closeness, std::move(c)};
  }
  return std::move(closest.second);
}

Case Climb::propose() {
  if (aim_at(law_.name) == Aim::kNothing) return generated();
  if (!score_) return closest_of(kStarts, [&] { return generated(); });
  return closest_of(kProposals, [&] {
    return within(subject_.claims, mutate_case(random_, at_, aim_at(law_.name)));
  });
}

void Climb::weigh(Case c, const Score& score) {
  if (score_ && score < *score_) return;
  at_ = std::move(c);
  score_ = score;
}

void hunt(Verification* verification, uint64_t seed, uint64_t number, uint64_t most) {
  const Law& law = *verification->verdict().law;
  Climb climb(law, verification->subject(), seed, number);
  for (uint64_t step = 0; step < std::min(most, kClimbCases); ++step) {
    if (verification->verdict().violation) return;
    Case c = climb.propose();
    const Score score = verification->check_hunted(c, number * kClimbCases + step);
    climb.weigh(std::move(c), score);
  }
}

}  // namespace selvage::spec
