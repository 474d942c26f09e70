// What reports/peers/findings.json says of the peers, against the peers: each finding's case still
// breaks its law, and no law is broken that no finding is about.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "spec/case.h"
#include "spec/promise.h"
#include "spec/verify.h"
#include "testbed/host.h"
#include "tests/matrix/patience.h"

namespace selvage::testbed {
namespace {

using json = nlohmann::ordered_json;

constexpr uint64_t kCases = 150;

class PeerFindings : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const auto library = std::filesystem::path(SELVAGE_PEER_SUBJECTS) / (GetParam() + ".so");
    if (!std::filesystem::exists(library)) GTEST_SKIP() << "this peer was not found";
    std::ifstream file(SELVAGE_FINDINGS);
    const json all = json::parse(file);
    findings_ = all.at(GetParam());
    subject_ = Host::subject(std::make_shared<Host>(library, kPatience));
    const auto examined = findings_.at("examined").get<std::string>();
    if (subject_.name.find(examined) == std::string::npos) {
      GTEST_SKIP() << "examined was " << examined << ", this is " << subject_.name;
    }
  }

  json findings_;
  spec::Subject subject_;
};

TEST_P(PeerFindings, HaveAKindASourceAndACaseThatStillFails) {
  for (const auto& [name, finding] : findings_.at("laws").items()) {
    SCOPED_TRACE(name);
    EXPECT_FALSE(finding.at("text").get<std::string>().empty());
    EXPECT_GT(finding.at("source").get<std::string>().size(), sizeof "not documented")
        << "where no documentation speaks, say where you looked";
    const auto kind = finding.at("kind").get<std::string>();
    EXPECT_TRUE(kind == "convention" || kind == "precision" || kind == "limit" || kind == "defect");
    const spec::Law* law = spec::find_law(name);
    const auto c = spec::from_hex(finding.at("case").get<std::string>());
    ASSERT_TRUE(law != nullptr && c);
    if (finding.value("varies", false)) continue;
    EXPECT_TRUE(spec::judge(*law, subject_, *c).violation)
        << "the finding is stale: its case holds\n"
        << spec::print(*c);
  }
}

TEST_P(PeerFindings, AreAboutEveryLawThatIsBroken) {
  for (const spec::Law& law : spec::laws()) {
    const spec::Promise promise = spec::promise(subject_.profile, subject_.claims, law.name);
    if (promise.standing != spec::Standing::kPromised) continue;
    if (findings_["laws"].contains(std::string(law.name))) continue;
    const spec::LawVerdict verdict = spec::verify(law, subject_, /*first_seed=*/1, kCases);
    EXPECT_FALSE(verdict.violation) << "no finding is about this\n"
                                    << spec::explain(*verdict.violation);
  }
}

INSTANTIATE_TEST_SUITE_P(All, PeerFindings,
                         testing::Values("agg", "allegro", "cairo", "llvmpipe", "opencv", "pixman",
                                         "qt", "sdl"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace selvage::testbed
