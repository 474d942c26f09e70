// Whoever calls may have the processor round, flush or trap as they like: no pixel changes, and the
// mode is theirs again afterwards.
#include <gtest/gtest.h>

#include <cfenv>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "mapper/nearest_rounding.h"
#include "selvage.h"
#include "spec/random.h"
#include "spec/verify.h"

namespace selvage::mapper {
namespace {

struct Mode {
  std::string name;
  std::function<void()> take;
};

[[nodiscard]] std::vector<Mode> modes() {
  std::vector<Mode> modes;
  const auto rounding = [&](const std::string& name, int mode) {
    modes.push_back({name, [mode] { ASSERT_EQ(std::fesetround(mode), 0); }});
  };
  rounding("Up", FE_UPWARD);
  rounding("Down", FE_DOWNWARD);
  rounding("TowardZero", FE_TOWARDZERO);
#ifdef __SSE2__
  modes.push_back({"Flushing", [] { __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() | 0x8040); }});
  // By the vectors' register alone, as some programs set it.
  modes.push_back({"UpByRegister",
                   [] { __builtin_ia32_ldmxcsr((__builtin_ia32_stmxcsr() & ~0x6000U) | 0x4000); }});
#endif
#if defined(__SSE2__) && defined(__GLIBC__)  // not all processors can trap
  modes.push_back({"Trapping", [] {
                     std::feclearexcept(FE_ALL_EXCEPT);
                     ASSERT_NE(feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW), -1);
                   }});
#endif
  return modes;
}

// What 1/3, and sums that round, come to: what tells one mode of rounding from another.
[[nodiscard]] std::vector<double> roundings() {
  volatile double one = 1, tiny = 0x1p-60;
  return {one / 3, -one / 3, one + tiny, one - tiny, -one - tiny};
}

// What else the processor has been told: to flush, to trap.
[[nodiscard]] unsigned told() {
#ifdef __SSE2__
  constexpr unsigned kFlags = 0x3F;
  return __builtin_ia32_stmxcsr() & ~kFlags;
#else
  return 0;
#endif
}

// Calls in this mode, and sees that it is the same one after.
template <class Call>
[[nodiscard]] auto called_in(const Mode& mode, Call call) {
  return [mode, call](auto... arguments) {
    std::fenv_t before;
    std::fegetenv(&before);
    mode.take();
    const std::vector<double> wanted = roundings();
    const unsigned told_before = told();
    const auto result = call(arguments...);
    const bool is_kept = roundings() == wanted && told() == told_before;
    std::fesetenv(&before);
    EXPECT_TRUE(is_kept) << mode.name;
    return result;
  };
}

class FloatModes : public testing::TestWithParam<Mode> {};

TEST_P(FloatModes, ChangeNoPixel) {
  spec::Subject subject = spec::built_in();
  subject.draw = called_in(GetParam(), subject.draw);
  subject.draw_many = called_in(GetParam(), subject.draw_many);
  subject.choose = called_in(GetParam(), subject.choose);
  for (const spec::Law& law : spec::laws()) {
    const spec::LawVerdict verdict = spec::verify(law, subject, /*first_seed=*/1, 200);
    EXPECT_FALSE(verdict.violation) << spec::explain(*verdict.violation);
  }
}

// near / w is below an odd multiple of 2^-25 by 2^-25 / w: whether that is rounded away decides q.
struct Depths {
  int64_t w, near;
};
[[nodiscard]] Depths any_near_half(spec::Random& random) {
  const int64_t w = (int64_t{1} << 28) + 2 * random.in(0, 1 << 29) + 1;
  int64_t near = w - 1;  // -1 / 2^25 modulo w
  for (int i = 0; i < 25; ++i) near = (near % 2 == 0 ? near : near + w) / 2;
  return {w, near};
}

TEST_P(FloatModes, ChangeNoVertex) {
  spec::Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto [w, near] = any_near_half(random);
    const double x = random.in(-1000, 1000) / 512.0 + random.in(-1, 2) * 0x1p-40;
    const auto snap = [&](selvage_vertex* vertex) {
      return selvage_snap(x, -x, x, -x, static_cast<double>(w), static_cast<double>(near), vertex);
    };
    selvage_vertex wanted{}, vertex{};
    const selvage_status status = snap(&wanted);
    ASSERT_EQ(called_in(GetParam(), snap)(&vertex), status);
    ASSERT_EQ(vertex.x, wanted.x) << x;
    ASSERT_EQ(vertex.u, wanted.u) << x;
    ASSERT_EQ(vertex.q, wanted.q) << w << " " << near;
  }
}

TEST_P(FloatModes, AreNearestRoundingWithin) {
  const std::vector<double> wanted = roundings();
  const auto within = [] {
    const NearestRounding rounding;
    return roundings();
  };
  EXPECT_EQ(called_in(GetParam(), within)(), wanted);
}

INSTANTIATE_TEST_SUITE_P(, FloatModes, testing::ValuesIn(modes()),
                         [](const auto& mode) { return mode.param.name; });

}  // namespace
}  // namespace selvage::mapper
