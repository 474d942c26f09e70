#include "reports/stability/contender.h"

#include <algorithm>
#include <string>

#include "reports/stability/arithmetic.h"
#include "spec/profiles.h"

namespace selvage::stability {
namespace {

[[nodiscard]] Contender of_mapper(const spec::Subject& mapper, const spec::Profile& profile) {
  const bool exact = profile.id == SELVAGE_PROFILE_EXACT;
  return {profile.name, profile.statement, exact ? Promise::kExact : Promise::kBound,
          profile.id,   profile.whole_px,  mapper};
}

}  // namespace

std::vector<Contender> contenders(const spec::Subject& mapper) {
  std::vector<Contender> all;
  for (const spec::Profile& profile : spec::profiles()) {
    if (profile.id != SELVAGE_PROFILE_EXACT) all.push_back(of_mapper(mapper, profile));
  }
  for (const Arithmetic& arithmetic : arithmetics()) {
    all.push_back({arithmetic.name,
                   arithmetic.statement,
                   Promise::kNothing,
                   SELVAGE_PROFILE_EXACT,
                   arithmetic.affine_only,
                   {std::string(arithmetic.name), arithmetic.draw}});
  }
  all.push_back(of_mapper(mapper, spec::profile_of(SELVAGE_PROFILE_EXACT)));
  return all;
}

Contender of_library(const spec::Subject& subject) {
  const bool is_bounded = !spec::draws_exactly(subject.claims);
  return {"subject",
          "the library that was given",
          is_bounded ? Promise::kBound : Promise::kNothing,
          subject.profile,
          !subject.claims.perspective,
          subject};
}

spec::Case in_its_way(const Contender& contender, const spec::Case& scene) {
  return spec::within(contender.subject.claims, spec::in_profile(scene, contender.profile));
}

bool can_draw(const Contender& contender, const spec::Case& scene, bool shows_address) {
  spec::Case whole = spec::in_profile(scene, contender.profile);
  spec::Case claimed = spec::within(contender.subject.claims, whole);
  for (spec::Case* c : {&whole, &claimed}) {
    c->format = SELVAGE_RGBA8888;
    c->flip_target = c->flip_texture = false;
    if (!shows_address) c->address = SELVAGE_ADDRESS_CLAMP;
    for (selvage_vertex& v : c->vertices) v.q = 1;
  }
  if (claimed == whole) return true;
  std::ranges::reverse(claimed.vertices);  // the other winding draws the same
  return claimed == whole;
}

}  // namespace selvage::stability
