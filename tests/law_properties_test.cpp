// Every law that a profile promises, as a RapidCheck property over generated cases.
// RC_PARAMS="seed=.. max_success=.." reruns or lengthens it; without, each law gets 1 000 cases.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <ostream>
#include <string>

#include "spec/generate.h"
#include "spec/generate_historic.h"
#include "spec/laws.h"
#include "spec/profiles.h"
#include "spec/verify.h"

namespace selvage::spec {

// How RapidCheck shows a case.
void showValue(const Case& c, std::ostream& os) { os << print(c) << "\n" << to_hex(c); }

namespace {

[[nodiscard]] rc::Gen<Case> any_case(selvage_profile profile) {
  const auto seed =
      rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<uint64_t>()));
  return rc::gen::shrink(rc::gen::map(seed, [=](uint64_t s) { return generate(s, profile); }),
                         [](const Case& c) { return rc::seq::fromContainer(simpler(c)); });
}

// A law that a profile promises, or is said to break.
struct Claim {
  const Law* law;
  const Profile* profile;
  Promise promise;
};

void PrintTo(const Claim& claim, std::ostream* os) {
  *os << claim.profile->name << " and law " << claim.law->name;
}

[[nodiscard]] std::vector<Claim> claims(Standing standing) {
  std::vector<Claim> all;
  for (const Profile& profile : profiles()) {
    for (const Law& law : laws()) {
      const Promise promised = promise(profile.id, law.name);
      if (promised.standing == standing) all.push_back({&law, &profile, promised});
    }
  }
  return all;
}

[[nodiscard]] std::string name_of(const testing::TestParamInfo<Claim>& info) {
  return std::string(info.param.profile->name) + "_" + std::string(info.param.law->name);
}

class PromisedLaws : public testing::TestWithParam<Claim> {};

TEST_P(PromisedLaws, HoldForTheBuiltInMapper) {
  const auto& [law, profile, promised] = GetParam();
  const Subject subject = built_in(profile->id);
  uint64_t judged_px = 0;
  const bool holds = rc::check(std::string(law->statement), [&] {
    const Case c = *any_case(profile->id).as("case");
    const Judgement judgement = law->check(subject, c);
    judged_px += judgement.judged_px;
    if (!judgement.violation) return;
    RC_LOG() << explain(*judgement.violation) << "\nreplay: selvage verify --law " << law->name
             << " --case " << to_hex(c) << "\n";
    RC_FAIL("law " + std::string(law->name) + " is broken");
  });
  EXPECT_TRUE(holds);
  EXPECT_GT(judged_px, 0U) << "law " << law->name << " had nothing to say";
}

INSTANTIATE_TEST_SUITE_P(, PromisedLaws, testing::ValuesIn(claims(Standing::kPromised)), name_of);

// Polygons in one call are drawn by kernels of their own, of which the laws reach the fastest
// alone.
TEST(KernelLaws, DrawTheSameInOneCall) {
  const Law& same = *find_law("SAME");
  for (const selvage_kernel kernel :
       {SELVAGE_KERNEL_SCALAR, SELVAGE_KERNEL_SSE4, SELVAGE_KERNEL_AVX2, SELVAGE_KERNEL_AVX512,
        SELVAGE_KERNEL_NEON}) {
    if (selvage_has_kernel(kernel) == 0) continue;
    Subject subject = built_in(SELVAGE_PROFILE_EXACT);
    take_kernel(kernel, &subject);
    const LawVerdict verdict = verify(same, subject, /*first_seed=*/1, 1000);
    EXPECT_FALSE(verdict.violation) << "kernel " << kernel << "\n" << explain(*verdict.violation);
  }
}

// What a profile does not promise is not promised for a reason: some case breaks it.
class UnpromisedLaws : public testing::TestWithParam<Claim> {};

TEST_P(UnpromisedLaws, AreBrokenBySomeCase) {
  const auto& [law, profile, promised] = GetParam();
  EXPECT_FALSE(promised.note.empty());
  const LawVerdict verdict = verify(*law, built_in(profile->id), /*first_seed=*/1, 1000);
  ASSERT_TRUE(verdict.violation) << profile->name << " keeps law " << law->name;
  EXPECT_TRUE(law->check(built_in(profile->id), *verdict.counterexample).violation);
}

INSTANTIATE_TEST_SUITE_P(, UnpromisedLaws, testing::ValuesIn(claims(Standing::kNotPromised)),
                         name_of);

}  // namespace
}  // namespace selvage::spec
