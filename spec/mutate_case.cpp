#include "spec/mutate_case.h"

#include <algorithm>

#include "spec/model.h"
#include "spec/profiles.h"

namespace selvage::spec {
namespace {

constexpr int kMostMutations = 3;
constexpr int kMostTries = 8;

// What a profile accepts and draws: mutations think of the exact one.
void accept(Case& c) {
  const Profile& profile = profile_of(c);
  for (selvage_vertex& v : c.vertices) {
    v.x = std::clamp(v.x, int32_t{SELVAGE_X_MIN}, SELVAGE_X_END - 1);
    v.y = std::clamp(v.y, int32_t{SELVAGE_X_MIN}, SELVAGE_X_END - 1);
  }
  if (!c.vertices.empty()) make_acceptable(profile, c.vertices);
  make_visible(profile, &c.vertices);
  if (!can_be_filtered(c)) c.filter = SELVAGE_FILTER_NEAREST;
}

// How many of a hundred mutations are of the outline and how many of the coordinates.
struct Shares {
  int outline, texels;
};
[[nodiscard]] Shares shares_of(Aim aim) {
  switch (aim) {
    case Aim::kEdges:
      return {70, 10};
    case Aim::kTexels:
      return {15, 65};
    case Aim::kBoth:
      return {40, 40};
    case Aim::kNothing:
      break;
  }
  return {30, 20};
}

[[nodiscard]] const Mutation& choose_mutation(Random& random, Aim aim) {
  const Shares shares = shares_of(aim);
  const int kind = random.in(0, 100);
  const std::span<const Mutation> mutations = kind < shares.outline ? outline_mutations()
                                              : kind < shares.outline + shares.texels
                                                  ? texel_mutations()
                                                  : drawing_mutations();
  return mutations[random.below(mutations.size())];
}

}  // namespace

Case mutated_by(const Mutation& mutation, Random& random, const Case& c) {
  Case changed = c;
  mutation.change(random, changed);
  accept(changed);
  return is_valid(changed) || !is_valid(c) ? changed : c;
}

Case mutate_case(Random& random, const Case& c, Aim aim) {
  Case changed = c;
  const int wanted = random.in(1, kMostMutations + 1);
  int made = 0;
  for (int tries = 0; made < wanted && tries < kMostTries; ++tries) {
    Case next = mutated_by(choose_mutation(random, aim), random, changed);
    if (next == changed) continue;
    changed = std::move(next);
    ++made;
  }
  return changed;
}

}  // namespace selvage::spec
