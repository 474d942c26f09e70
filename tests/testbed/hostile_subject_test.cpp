// Subjects that do harm: each is named for what it did, the next case is judged as if nothing had
// been, and so are the other laws.
#include <gtest/gtest.h>

#include <string>

#include "spec/generate_historic.h"
#include "spec/model.h"
#include "spec/verify.h"
#include "support.h"

namespace selvage::testbed::test {
namespace {

struct Hostile {
  const char* library;
  const char* happened;
};

void PrintTo(const Hostile& hostile, std::ostream* out) { *out << hostile.library; }

class HostileSubject : public testing::TestWithParam<Hostile> {};

TEST_P(HostileSubject, IsNamedAndShrunk) {
  const spec::Subject subject = Host::subject(host_of(GetParam().library));
  for (const char* law : {"COV", "MEM", "TOTAL", "SAME"}) {
    const spec::LawVerdict verdict = spec::verify(*spec::find_law(law), subject, 1, 20);
    ASSERT_TRUE(verdict.violation) << law;
    EXPECT_EQ(verdict.violation->law, law);
    const std::string told = spec::explain(*verdict.violation);
    EXPECT_NE(told.find("it " + std::string(GetParam().happened)), std::string::npos) << told;
    EXPECT_LE(verdict.counterexample->vertices.size(), 3u) << told;
    EXPECT_LE(verdict.counterexample->target_width_px, 2) << told;
    EXPECT_TRUE(spec::judge(*spec::find_law(law), subject, *verdict.counterexample).violation)
        << "a replay shows it again";
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, HostileSubject,
    testing::Values(
        Hostile{"crashes", "wrote through a null pointer (SIGSEGV)"},
        Hostile{"writes_after", "wrote just after the end of the target, where pixel ("},
        Hostile{"writes_before", "wrote 1 byte before the start of the target, where pixel ("},
        Hostile{"writes_texture", "wrote in the texture, at texel (0, 0) (SIGSEGV)"},
        Hostile{"writes_vertices", "wrote in the vertices (SIGSEGV)"},
        Hostile{"reads_past_texture", "read just after the end of the texture, at texel ("},
        Hostile{"recurses", "ran out of stack (SIGSEGV)"},
        Hostile{"fills_stack", "ran out of stack (SIGSEGV)"},
        Hostile{"divides", "divided by zero, or alike (SIGFPE)"},
        Hostile{"aborts", "aborted (SIGABRT)"}, Hostile{"exits", "exited with status 3"},
        Hostile{"raises", "was ended by a signal that was sent to it (SIGSEGV)"},
        Hostile{"kills_parent",
                "ended the process that holds it, which was ended by a signal (SIGKILL)"},
        Hostile{"stops_keeper", "stopped the process that holds it (SIGSTOP)"},
        Hostile{"throws", "threw an exception through the C interface"}),
    [](const auto& test) { return std::string(test.param.library); });

TEST(HostileSubjectThatHangs, TakesItsTimeAndNoMore) {
  const spec::Subject subject = Host::subject(host_of("hangs", std::chrono::milliseconds(200)));
  for (const char* law : {"COV", "MEM"}) {
    const spec::LawVerdict verdict = spec::verify(*spec::find_law(law), subject, 1, 20);
    ASSERT_TRUE(verdict.violation);
    const std::string& drawn = verdict.violation->drawn;
    EXPECT_EQ(drawn.rfind("it hung: no answer in 0.2 s", 0), 0u)
        << drawn;  // more on a busy machine
  }
}

// Both end for want of something that a fault or a time alone does not tell.
TEST(HostileSubjectThatTakesMemory, IsToldHowMuchItTook) {
  const auto drawn = [](const char* name, std::chrono::nanoseconds limit) {
    const spec::Subject subject = Host::subject(host_of(name, limit));
    const spec::Judgement judgement =
        spec::judge(*spec::find_law("COV"), subject, spec::generate(1, SELVAGE_PROFILE_EXACT));
    return judgement.violation ? judgement.violation->drawn : "";
  };
  const std::string all = drawn("takes_memory_all", std::chrono::minutes(5));
  EXPECT_EQ(all.rfind("it wrote through a null pointer (SIGSEGV), with ", 0), 0u) << all;
  EXPECT_NE(all.find(" MiB of memory in use; it may take 1024"), std::string::npos) << all;
  const std::string much = drawn("takes_memory_much", std::chrono::seconds(10));
  EXPECT_EQ(much.rfind("it hung: no answer in 10 s", 0), 0u) << much;
  EXPECT_NE(much.find(", with "), std::string::npos) << much;
  EXPECT_NE(much.find(" MiB of memory in use; it may take 1024"), std::string::npos) << much;
}

TEST(HostileSubjectThatDrawsNothing, IsNoCrash) {
  const spec::Subject subject = Host::subject(host_of("draws_nothing"));
  const spec::LawVerdict verdict = spec::verify(*spec::find_law("COV"), subject, 1, 50);
  ASSERT_TRUE(verdict.violation);
  EXPECT_EQ(verdict.violation->drawn, "nothing");
  EXPECT_TRUE(spec::verify(*spec::find_law("TOTAL"), subject, 1, 50).violation);
}

TEST(HostileSubjectThatWritesBetweenRows, BreaksMem) {
  const spec::Subject subject = Host::subject(host_of("writes_padding"));
  const spec::LawVerdict verdict = spec::verify(*spec::find_law("MEM"), subject, 1, 100);
  ASSERT_TRUE(verdict.violation);
  EXPECT_EQ(verdict.violation->drawn, "a byte outside the target's pixels was written");
}

// Calls get their memory in turn; only SAME has one texture lie where another one lay.
TEST(SubjectThatRemembersATextureByItsAddress, BreaksSame) {
  const spec::Subject subject = Host::subject(host_of("remembers"));
  const spec::LawVerdict verdict = spec::verify(*spec::find_law("SAME"), subject, 1, 50);
  ASSERT_TRUE(verdict.violation);
  EXPECT_NE(verdict.violation->what.find("from the memory that held the one before"),
            std::string::npos)
      << verdict.violation->what;
  EXPECT_EQ(verdict.replays.failed, verdict.replays.tried);
}

TEST(SubjectOfOneWinding, HoldsIfItSaysSo) {
  const spec::Law &cov = *spec::find_law("COV"), &order = *spec::find_law("ORDER");
  const spec::Subject claims = Host::subject(host_of("clockwise"));
  EXPECT_FALSE(spec::verify(cov, claims, 1, 200).violation);
  EXPECT_FALSE(spec::verify(order, claims, 1, 200).violation);
  const spec::Subject secret = Host::subject(host_of("clockwise_in_secret"));
  EXPECT_TRUE(spec::verify(cov, secret, 1, 200).violation);
  EXPECT_TRUE(spec::verify(order, secret, 1, 200).violation);
}

class MeddlingSubject : public testing::TestWithParam<Hostile> {};

// What it does may come to light in a later call alone.
TEST_P(MeddlingSubject, IsNamedAndTheRunGoesOn) {
  const spec::Subject subject = Host::subject(host_of(GetParam().library, std::chrono::seconds(5)));
  for (const char* law : {"COV", "MEM"}) {
    const spec::LawVerdict verdict = spec::verify(*spec::find_law(law), subject, 1, 100);
    ASSERT_TRUE(verdict.violation) << law;
    const std::string told = spec::explain(*verdict.violation);
    EXPECT_NE(told.find("it " + std::string(GetParam().happened)), std::string::npos) << told;
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, MeddlingSubject,
    testing::Values(Hostile{"rounds_up", "left its caller's floating-point numbers to be rounded"},
                    Hostile{"flushes", "left its caller's floating-point numbers to be rounded"},
                    Hostile{"rings", "was ended by a signal (SIGALRM)"},
                    Hostile{"crashes_later", "was ended by a signal that was sent to it (SIGSEGV)"},
                    Hostile{"longjmps", ""},
                    Hostile{"unmaps", "wrote in the target, where pixel ("},
                    Hostile{"exits_forked", "exited with status 9"}),
    [](const auto& test) { return std::string(test.param.library); });

TEST(SubjectThatHangsWhereItIsForked, IsNamed) {
  const spec::Subject subject =
      Host::subject(host_of("hangs_forked", std::chrono::milliseconds(200)));
  const spec::Judgement judgement =
      spec::judge(*spec::find_law("COV"), subject, spec::generate(1, SELVAGE_PROFILE_EXACT));
  ASSERT_TRUE(judgement.violation);
  EXPECT_EQ(judgement.violation->drawn, "it left no process to draw in within 5 s");
}

// What a subject does to its own process is its own affair, as long as it draws.
TEST(SubjectThatMeddlesWithItsProcess, IsJudgedByItsPictures) {
  for (const char* name :
       {"closes_files", "changes_folder", "undoes_death", "leaves_group", "catches_signals",
        "blocks_signals", "limits_itself", "ignores_children", "rings_loaded"}) {
    const spec::Subject subject = Host::subject(host_of(name));
    for (const char* law : {"COV", "MEM"}) {
      const spec::LawVerdict verdict = spec::verify(*spec::find_law(law), subject, 1, 100);
      EXPECT_FALSE(verdict.violation) << name << '\n' << spec::explain(*verdict.violation);
    }
  }
}

// What goes on beside the calls is nobody's picture.
TEST(SubjectThatLeavesThingsBehind, IsJudgedByItsPictures) {
  for (const char* name : {"leaks", "forks", "prints"}) {
    const spec::Subject subject = Host::subject(host_of(name));
    for (const char* law : {"COV", "MEM"}) {
      const spec::LawVerdict verdict = spec::verify(*spec::find_law(law), subject, 1, 100);
      EXPECT_FALSE(verdict.violation) << name << '\n' << spec::explain(*verdict.violation);
    }
  }
}

}  // namespace
}  // namespace selvage::testbed::test
