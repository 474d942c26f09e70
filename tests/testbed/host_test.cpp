// What a host makes of a library: its name and claims, its output, its errors.
#include "testbed/host.h"

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "spec/generate_historic.h"
#include "spec/picture.h"
#include "spec/promise.h"
#include "spec/verify.h"
#include "support.h"

namespace selvage::testbed::test {
namespace {

[[nodiscard]] std::string refusal_of(const std::filesystem::path& path,
                                     std::chrono::milliseconds limit = kPatience) {
  try {
    const auto host = std::make_shared<Host>(path, limit);
    const spec::Subject subject = Host::subject(host);
  } catch (const LibraryError& error) {
    return error.what();
  }
  ADD_FAILURE() << path << " was loaded";
  return {};
}

void expect_refused(const std::filesystem::path& path, const std::string& why,
                    std::chrono::milliseconds limit = kPatience) {
  const std::string text = refusal_of(path, limit);
  EXPECT_NE(text.find("cannot use '" + path.string() + "' as a subject: "), std::string::npos);
  EXPECT_NE(text.find(why), std::string::npos) << "no '" << why << "' in: " << text;
}

TEST(Host, RefusesWhatIsNoSubject) {
  expect_refused(library("not_there"), "there is no such file");
  expect_refused(SELVAGE_SUBJECTS, "it is a directory; the name of a shared library is right");
  const auto fifo =
      std::filesystem::temp_directory_path() / ("selvage-fifo-" + std::to_string(getpid()));
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  expect_refused(fifo, "it is no regular file; the name of a shared library is right");
  std::filesystem::remove(fifo);
  expect_refused(library("no_draw"), "it exports no selvage_draw");
  expect_refused(library("prepares_half"),
                 "it exports selvage_prepare and no selvage_prepare_bytes; both are needed");
  const auto text = std::filesystem::temp_directory_path() / "selvage-no-library.so";
  std::ofstream(text) << "no library\n";
  expect_refused(text, "no-library.so: ");
  std::filesystem::remove(text);
}

TEST(Host, OutlivesALibraryThatCannotBeLoaded) {
  const std::string described = "its selvage_subject()", process = " the process that does so";
  const std::pair<const char*, std::string> endings[] = {
      {"exits",
       " ends" + process + ", which exited with status 7; it printed: no licence was found"},
      {"crashes", " ends" + process + ", which touched memory that it was not given (SIGSEGV)"},
      {"stops", " stops" + process + " (SIGSTOP)"}};
  for (const auto& [name, ending] : endings) {
    expect_refused(library(name + std::string("_loaded")), "loading it" + ending);
    expect_refused(library(name + std::string("_described")), described + ending);
  }
  const std::chrono::milliseconds limit(300);
  const std::string late = " takes longer than a call may, 0.3 s";
  expect_refused(library("hangs_on_load"), "loading it" + late, limit);
  expect_refused(library("hangs_loaded"), "loading it" + late, limit);
  expect_refused(library("hangs_described"), described + late, limit);
}

// The copy must not answer in the keeper's place.
TEST(Host, EndsWhatALibraryForksWhileItIsLoaded) {
  const std::string loaded = "forks_loaded_", described = "forks_described_";
  for (const char* copy : {"late", "refuses", "stays"}) {
    for (const std::string& when : {loaded, described}) {
      const spec::Subject subject = Host::subject(host_of(when + copy));
      EXPECT_EQ(subject.name, "forks early") << when << copy;
      const spec::LawVerdict verdict = spec::verify(*spec::find_law("COV"), subject, 1, 40);
      EXPECT_FALSE(verdict.violation) << when << copy << spec::explain(*verdict.violation);
    }
  }
  expect_refused(library(loaded + "alone"), "loading it ends the process that does so");
  expect_refused(library(described + "alone"), "its selvage_subject() ends the process that does");
}

// What has lost its parent becomes this process's child.
TEST(Host, LeavesNoProcessBehind) {
  ASSERT_EQ(prctl(PR_SET_CHILD_SUBREAPER, 1), 0);
  (void)host_of("forks_loaded_stays");
  (void)host_of("forks_described_stays");
  pid_t ended = 0;
  for (int i = 0; ended >= 0 && i < 500; ++i) {
    ended = waitpid(-1, nullptr, WNOHANG);
    if (ended == 0) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(ended, -1) << "there is still one";
  prctl(PR_SET_CHILD_SUBREAPER, 0);
}

TEST(Host, RefusesClaimsOfWhatThereIsNot) {
  expect_refused(library("claims_no_size"), "the field must be set to sizeof(selvage_claims)");
  expect_refused(library("claims_a_filter"), "nearest must be among them");
  expect_refused(library("claims_a_profile"), "has profile 9; a selvage_profile is right");
  for (const auto& [name, accuracy] :
       {std::pair{"claims_no_accuracy", "-1"}, std::pair{"claims_bounds_and_accuracy", "1"}}) {
    expect_refused(library(name), "has accuracy " + std::string(accuracy) +
                                      "; 0 is right, and in profile exact 1/65536 texel");
  }
}

TEST(Host, RefusesCoverageThatIsOffByMoreThanAPixel) {
  for (const auto& [name, accuracy] :
       {std::pair{"claims_wide_coverage", "65537"}, std::pair{"claims_bounds_and_coverage", "1"}}) {
    expect_refused(library(name), "has coverage_accuracy " + std::string(accuracy) +
                                      "; 0 is right, and in profile exact 1/65536 px to 1 px");
  }
  expect_refused(library("claims_no_guard_band"),
                 "has guard_band_px -1; 0, for any, or at least 1");
}

TEST(Host, RefusesStepsThatAreNoPowersOfTwo) {
  expect_refused(library("claims_no_step"),
                 "has position_step 48; 0, for 1, or a power of two up to 256 is right");
  expect_refused(library("claims_long_step"),
                 "has coordinate_step 131072; 0, for 1, or a power of two up to 65536 is right");
}

TEST(Host, TakesALibraryWithoutClaimsForAllOfTheExactProfile) {
  const spec::Subject subject = Host::subject(host_of("right"));
  EXPECT_EQ(subject.name, "right.so");
  EXPECT_EQ(subject.profile, SELVAGE_PROFILE_EXACT);
  EXPECT_EQ(subject.claims, spec::Capabilities{});
}

TEST(Host, ReadsClaims) {
  const spec::Subject subject = Host::subject(host_of("claims_little"));
  EXPECT_EQ(subject.name, "little 7");
  const spec::Capabilities little{.winding = spec::Winding::kBoth,
                                  .formats = spec::only(SELVAGE_RGBA8888),
                                  .filters = spec::only(SELVAGE_FILTER_NEAREST),
                                  .addresses = spec::only(SELVAGE_ADDRESS_CLAMP),
                                  .perspective = false,
                                  .clip = false,
                                  .negative_pitch = false,
                                  .concave = false,
                                  .named_errors = false,
                                  .any_texture_side = false,
                                  .outside_texels = false,
                                  .longest_side_px = 40,
                                  .longest_side_texel = 64,
                                  .most_vertices = 3,
                                  .guard_band_px = 0};
  EXPECT_EQ(subject.claims, little);
  EXPECT_EQ(Host::subject(host_of("off_within")).claims.accuracy_fx16, 256);
  const spec::Capabilities old = Host::subject(host_of("claims_of_old")).claims;
  EXPECT_EQ(old.most_vertices, 5);
  EXPECT_EQ(old.accuracy_fx16, 0) << "which it did not know";
  const spec::Capabilities steps = Host::subject(host_of("claims_steps")).claims;
  EXPECT_EQ(steps.position_step_fx8, 16);
  EXPECT_EQ(steps.coordinate_step_fx16, 65536);
  const spec::Capabilities rounded = Host::subject(host_of("claims_coverage")).claims;
  EXPECT_EQ(rounded.coverage_accuracy_fx16, 256);
  EXPECT_EQ(rounded.guard_band_px, 1024);
  const spec::Capabilities older = Host::subject(host_of("claims_before_coverage")).claims;
  EXPECT_EQ(older.accuracy_fx16, 7);
  EXPECT_EQ(older.coverage_accuracy_fx16, 0) << "which it did not know";
}

// Terminals obey escape sequences, and XML ends at a byte that is no UTF-8.
TEST(Host, MakesANameFitToBeShown) {
  const spec::Subject subject = Host::subject(host_of("names_bytes"));
  const std::string bad = "\xEF\xBF\xBD";
  std::string version;
  for (int i = 0; i < 12; ++i) version += "1234567890";
  EXPECT_EQ(subject.name,
            "a" + bad + "[31m" + bad + bad + "<&\">" + bad + bad + " b " + version + "123456");
  const auto path = std::filesystem::temp_directory_path() / "selvage-\x1B[31m\xFF.so";
  std::filesystem::copy_file(library("right"), path,
                             std::filesystem::copy_options::overwrite_existing);
  EXPECT_EQ(Host::subject(std::make_shared<Host>(path, kPatience)).name,
            "selvage-" + bad + "[31m" + bad + ".so");
  std::filesystem::remove(path);
  const std::string refused = refusal_of(path);
  EXPECT_NE(refused.find("selvage-" + bad + "[31m" + bad + ".so'"), std::string::npos) << refused;
}

TEST(Host, DrawsWhatTheMapperDraws) {
  const spec::Subject subject = Host::subject(host_of("right"));
  for (uint64_t seed = 1; seed <= 300; ++seed) {
    const spec::Case c = spec::generate(seed, SELVAGE_PROFILE_EXACT);
    spec::Subject ours = spec::built_in();
    ours.prepare.reset();
    const spec::Picture theirs = spec::draw(subject, c), right = spec::draw(ours, c);
    ASSERT_EQ(theirs.status, right.status) << spec::print(c);
    ASSERT_EQ(theirs.pixels, right.pixels) << spec::print(c);
    ASSERT_EQ(theirs.memory_fault, "") << spec::print(c);
  }
}

// All laws, each with all that it calls a subject by, bad arguments among them.
TEST(Host, LetsARightMapperHoldAllLaws) {
  const spec::Subject right = Host::subject(host_of("right"));
  const spec::Subject little = Host::subject(host_of("claims_little"));
  for (const spec::Subject& subject : {right, little}) {
    for (const spec::Law& law : spec::laws()) {
      const spec::Promise promise = spec::promise(subject.profile, subject.claims, law.name);
      if (promise.standing != spec::Standing::kPromised) continue;
      const spec::LawVerdict verdict = spec::verify(law, subject, 1, 60);
      EXPECT_FALSE(verdict.violation) << subject.name << '\n' << spec::explain(*verdict.violation);
      EXPECT_GT(verdict.judged_px, 0u) << subject.name << ' ' << law.name;
    }
  }
}

TEST(Host, KeepsWhatTheSubjectPrintsToItself) {
  const auto host = host_of("prints");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  (void)spec::draw(Host::subject(host), spec::generate(1, SELVAGE_PROFILE_EXACT));
  for (uint64_t seed = 2; host->printed().empty() && seed < 20; ++seed) {
    (void)spec::draw(Host::subject(host), spec::generate(seed, SELVAGE_PROFILE_EXACT));
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
  EXPECT_NE(host->printed().find("vertices\n"), std::string::npos);
  EXPECT_NE(host->printed().find("and says so\n"), std::string::npos);
}

}  // namespace
}  // namespace selvage::testbed::test
