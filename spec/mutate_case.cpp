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

[[nodiscard]] const Mutation& choose_mutation(Random& random, Aim aim) {
  const int kind = random.in(0, 100);
  const int edges = aim == Aim::kEdges ? 70 : aim == Aim::kTexels ? 15 : 40;
  const int texels = aim == Aim::kEdges ? 10 : aim == Aim::kTexels ? 65 : 40;
  const std::span<const Mutation> mutations = kind < edges            ? outline_mutations()
                                              : kind < edges + texels ? texel_mutations()
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
