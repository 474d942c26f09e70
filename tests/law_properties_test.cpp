// Every law, as a RapidCheck property over generated cases. RC_PARAMS="seed=.. max_success=.."
// reruns or lengthens it; without, each law gets 1 000 cases.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <ostream>
#include <string>

#include "spec/generate.h"
#include "spec/laws.h"

namespace selvage::spec {

// How RapidCheck shows a case.
void showValue(const Case& c, std::ostream& os) { os << print(c) << "\n" << to_hex(c); }

namespace {

[[nodiscard]] rc::Gen<Case> any_case() {
  const auto seed =
      rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<uint64_t>()));
  return rc::gen::shrink(rc::gen::map(seed, [](uint64_t s) { return generate(s); }),
                         [](const Case& c) { return rc::seq::fromContainer(simpler(c)); });
}

class LawProperties : public testing::TestWithParam<const Law*> {};

TEST_P(LawProperties, HoldForTheBuiltInMapper) {
  const Law& law = *GetParam();
  const Subject subject = built_in();
  uint64_t judged_px = 0;
  const bool holds = rc::check(std::string(law.statement), [&] {
    const Case c = *any_case().as("case");
    const Judgement judgement = law.check(subject, c);
    judged_px += judgement.judged_px;
    if (!judgement.violation) return;
    RC_LOG() << explain(*judgement.violation) << "\nreplay: selvage verify --law " << law.name
             << " --case " << to_hex(c) << "\n";
    RC_FAIL("law " + std::string(law.name) + " is broken");
  });
  EXPECT_TRUE(holds);
  EXPECT_GT(judged_px, 0U) << "law " << law.name << " had nothing to say";
}

[[nodiscard]] std::vector<const Law*> every_law() {
  std::vector<const Law*> all;
  for (const Law& law : laws()) all.push_back(&law);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Exact, LawProperties, testing::ValuesIn(every_law()),
                         [](const auto& of) { return std::string(of.param->name); });

}  // namespace
}  // namespace selvage::spec
