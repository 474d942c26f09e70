// The calls that a library may have besides selvage_draw: where it exports them they are held to
// their laws, in its process and between guards as well.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "spec/verify.h"
#include "support.h"

namespace selvage::testbed::test {
namespace {

[[nodiscard]] spec::LawVerdict held(const char* law, const std::string& name) {
  return spec::verify(*spec::find_law(law), Host::subject(host_of(name)), 1, 60);
}

TEST(ExportedCalls, AreThoseOfTheLibraryThatDraws) {
  const spec::Subject right = Host::subject(host_of("right"));
  EXPECT_FALSE(right.draw_many || right.prepare || right.choose)
      << "those that it is linked with are not its own";
  EXPECT_TRUE(Host::subject(host_of("draws_many_right")).draw_many);
  EXPECT_TRUE(Host::subject(host_of("prepares_right")).prepare);
  EXPECT_TRUE(Host::subject(host_of("chooses_right")).choose);
}

TEST(ExportedCalls, OfARightMapperHold) {
  const auto host = std::make_shared<Host>(SELVAGE_SHARED_LIBRARY, kPatience);
  const spec::Subject whole = Host::subject(host);
  ASSERT_TRUE(whole.draw_many && whole.prepare && whole.choose);
  for (const spec::Law& law : spec::laws()) {
    const spec::LawVerdict verdict = spec::verify(law, whole, 1, 60);
    EXPECT_FALSE(verdict.violation) << spec::explain(*verdict.violation);
    EXPECT_TRUE(verdict.not_claimed.empty()) << law.name;
  }
  const uint64_t drawing = held("SAME", "right").judged_px;
  for (const char* name : {"draws_many_right", "prepares_right"}) {
    const spec::LawVerdict verdict = held("SAME", name);
    EXPECT_FALSE(verdict.violation) << name << '\n' << spec::explain(*verdict.violation);
    EXPECT_GT(verdict.judged_px, drawing) << name << ": what it adds is judged";
  }
  EXPECT_FALSE(held("TOLERANCE", "chooses_right").violation);
}

// A layout that the library says is beyond it leaves what is to be said of the others.
TEST(ExportedCalls, MayLackALayout) {
  const spec::LawVerdict verdict = held("SAME", "prepares_no_tiles");
  EXPECT_FALSE(verdict.violation);
  EXPECT_GT(verdict.judged_px, 0u);
  EXPECT_GT(verdict.not_claimed.at("what it says itself is beyond it"), 0u);
}

TEST(ExportedCalls, AreNotGivenMemoryWithoutEnd) {
  const spec::LawVerdict verdict = held("SAME", "prepares_too_much");
  EXPECT_FALSE(verdict.violation);
  EXPECT_GT(verdict.not_claimed.at("more memory to prepare in than can be handed on"), 0u);
}

struct Wrong {
  const char *library, *law, *told;
  uint64_t cases = 60;
};

void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.library; }

class WrongCall : public testing::TestWithParam<Wrong> {};

TEST_P(WrongCall, IsNamedAndShrunk) {
  const auto& [library, law, told, cases] = GetParam();
  const spec::Subject subject = Host::subject(host_of(library));
  const spec::LawVerdict verdict = spec::verify(*spec::find_law(law), subject, 1, cases);
  ASSERT_TRUE(verdict.violation);
  const std::string text = spec::explain(*verdict.violation);
  EXPECT_NE(text.find(told), std::string::npos) << text;
  EXPECT_LE(verdict.counterexample->vertices.size(), 4u) << text;
  EXPECT_TRUE(spec::judge(*spec::find_law(law), subject, *verdict.counterexample).violation)
      << "a replay shows it again";
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongCall,
    testing::Values(
        Wrong{"draws_many_backward", "SAME", "polygons drawn in one call, by 1 thread, show what "},
        Wrong{"draws_many_threads", "SAME", "polygons drawn in one call, by 2 threads, show what "},
        Wrong{"draws_many_past_scratch", "SAME",
              "it wrote just after the end of the scratch memory"},
        Wrong{"draws_many_polygons_back", "SAME", "it wrote in the list of polygons"},
        Wrong{"draws_many_past_texels", "SAME",
              "given: selvage_draw_many\n  allowed  a picture or a named error\n"
              "  drawn    it read just after the end of the texture, at texel ("},
        Wrong{"prepares_spoiled", "SAME", "a texture prepared in tiles draws what rows as given"},
        Wrong{"prepares_spoiled", "MAP", "prepared in tiles"},
        Wrong{"prepares_elsewhere", "SAME",
              "it prepared a texture whose texels lie outside of the memory that it was given"},
        Wrong{"prepares_past_end", "SAME", "after the end of the memory to prepare in"},
        Wrong{"prepares_source", "MEM", "it wrote in the texture, at texel (0, 0) (SIGSEGV)"},
        Wrong{"prepares_later", "COV", "it wrote in the prepared texture"},
        Wrong{"chooses_lower_bound", "TOLERANCE", "the bound is less than the derived one"},
        // Which cases show it depends on the kernels that the build and the machine have.
        Wrong{"chooses_exact", "TOLERANCE", "a texel lies within 0 texel of its exact (u, v)", 400},
        Wrong{"chooses_crashes", "TOLERANCE",
              "it wrote in the structures that hold its arguments"}),
    [](const auto& test) {
      return std::string(test.param.library) + "_" + std::string(test.param.law);
    });

}  // namespace
}  // namespace selvage::testbed::test
