#include "spec/capabilities.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <utility>

#include "spec/generate_historic.h"
#include "spec/law_tools.h"
#include "spec/model.h"
#include "spec/promise.h"
#include "spec/texel_reach.h"
#include "spec/verify.h"
#include "tests/expect_to_hold.h"

namespace selvage::spec {
namespace {

[[nodiscard]] std::vector<Capabilities> some_claims() {
  std::vector<Capabilities> some(18);
  some[0].winding = Winding::kClockwise;
  some[1].winding = Winding::kCounterClockwise;
  some[2].formats = only(SELVAGE_RGB565);
  some[3].filters = only(SELVAGE_FILTER_NEAREST) | only(SELVAGE_FILTER_BILINEAR);
  some[4].addresses = only(SELVAGE_ADDRESS_WRAP);
  some[5].perspective = some[5].clip = some[5].negative_pitch = false;
  some[6].concave = false;
  some[7].longest_side_px = 5;
  some[7].longest_side_texel = 3;
  some[8].most_vertices = 3;
  some[10].any_texture_side = false;
  some[11].outside_texels = false;
  some[11].any_texture_side = false;
  some[11].addresses = only(SELVAGE_ADDRESS_CLAMP);
  some[12].position_step_fx8 = 16;
  some[13].position_step_fx8 = 256;
  some[13].coordinate_step_fx16 = 256;
  some[14].coordinate_step_fx16 = 65536;
  some[15].position_step_fx8 = 128;
  some[15].coordinate_step_fx16 = 4096;
  some[15].winding = Winding::kCounterClockwise;
  some[15].most_vertices = 3;
  some[15].outside_texels = false;
  some[16].guard_band_px = 0;
  some[17].guard_band_px = 5;
  some[17].position_step_fx8 = 16;
  some[17].most_vertices = 3;
  some[9].winding = Winding::kClockwise;
  some[9].most_vertices = 4;
  some[9].perspective = false;
  return some;
}

TEST(Capabilities, ThatAreAllLeaveEveryCaseAsItIs) {
  for (uint64_t seed = 0; seed < 500; ++seed) {
    const Case c = generate(seed, SELVAGE_PROFILE_EXACT);
    EXPECT_EQ(within({}, c), c);
    EXPECT_EQ(beyond({}, c), std::nullopt);
  }
}

// Nothing is lost on the way but what must be refused, and what is within stays.
TEST(Capabilities, HoldEveryCaseThatIsBroughtWithinThem) {
  for (const Capabilities& claims : some_claims()) {
    int changed = 0;
    for (uint64_t seed = 0; seed < 500; ++seed) {
      const Case c = generate(seed, SELVAGE_PROFILE_EXACT);
      const Case taken = within(claims, c);
      EXPECT_EQ(beyond(claims, taken), std::nullopt) << print(c) << print(taken);
      EXPECT_TRUE(beyond(claims, c) || !is_valid(c) || taken == c) << print(c);
      changed += taken == c ? 0 : 1;
    }
    EXPECT_GT(changed, 50);
  }
}

TEST(Capabilities, NameWhatIsBeyondThem) {
  Case c;
  c.vertices = {{0, 0, 0, 0, 1}, {256, 0, 0, 0, 2}, {0, 256, 0, 0, 1}};
  Capabilities flat;
  flat.perspective = false;
  EXPECT_EQ(beyond(flat, c), "perspective");
  Capabilities turned;
  turned.winding = Winding::kCounterClockwise;
  EXPECT_EQ(beyond(turned, c), "an outline that it does not draw");
  Capabilities unnamed;
  unnamed.named_errors = false;
  EXPECT_EQ(beyond(unnamed, c), std::nullopt);
  c.vertices.pop_back();
  EXPECT_EQ(beyond(unnamed, c), "an outline to be refused");
}

TEST(Capabilities, MoveVerticesDownToTheirSteps) {
  Case c;
  c.vertices = {{-1, 257, -1, 65537, 1}, {1000, 20, 40, 80, 1}, {-300, 4000, 70000, -70000, 1}};
  Capabilities coarse;
  coarse.position_step_fx8 = 256;
  coarse.coordinate_step_fx16 = 65536;
  EXPECT_EQ(beyond(coarse, c), "vertices between the places that it takes");
  const Case taken = within(coarse, c);
  EXPECT_EQ(taken.vertices[0].x, -256);
  EXPECT_EQ(taken.vertices[0].y, 256);
  EXPECT_EQ(taken.vertices[0].u, -65536);
  EXPECT_EQ(taken.vertices[0].v, 65536);
  for (const char* law : {"PINWHEEL", "VERT"}) {
    EXPECT_EQ(promise(SELVAGE_PROFILE_EXACT, coarse, law).standing, Standing::kNotPromised) << law;
  }
  coarse.position_step_fx8 = 128;
  for (const char* law : {"PINWHEEL", "VERT"}) {
    EXPECT_EQ(promise(SELVAGE_PROFILE_EXACT, coarse, law).standing, Standing::kPromised) << law;
  }
}

// The generator's cases are moved; laws that make vertices of their own must keep to the steps,
// too.
TEST(CapabilitiesAtLength, AskForNoVertexBetweenItsSteps) {
  for (const auto& [position_fx8, coordinate_fx16] :
       {std::pair{16, 1}, {256, 65536}, {1, 65536}, {128, 256}}) {
    Subject subject = built_in();
    subject.claims.position_step_fx8 = position_fx8;
    subject.claims.coordinate_step_fx16 = coordinate_fx16;
    subject.claims.named_errors = false;
    subject.draw = [=](const selvage_image* target, const selvage_rect* clip,
                       const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                       const selvage_options* options) {
      for (const selvage_vertex& v : std::span(vertices, count)) {
        if (v.x % position_fx8 == 0 && v.y % position_fx8 == 0 && v.u % coordinate_fx16 == 0 &&
            v.v % coordinate_fx16 == 0) {
          continue;
        }
        throw SubjectFailure{"was given a vertex that it does not take"};
      }
      return selvage_draw(target, clip, vertices, count, texture, options);
    };
    expect_to_hold(subject, 200, [](const Law& law) { return law.name == "MEM" ? 200 : 0; });
  }
}

// Nor one that lies too far from the target, in any drawing and in any call.
TEST(CapabilitiesAtLength, AskForNoVertexBeyondTheGuardBand) {
  for (const auto& [band_px, step_fx8] : {std::pair{0, 1}, {0, 16}, {3, 1}, {1000, 128}}) {
    const auto expect_near = [=](const selvage_image* target, const selvage_vertex* vertices,
                                 size_t count) {
      const auto is_near = [=](int32_t at_fx8, int32_t side_px) {
        return -256 * band_px <= at_fx8 && at_fx8 <= 256 * (side_px + band_px);
      };
      for (const selvage_vertex& v : std::span(vertices, count)) {
        if (is_near(v.x, target->width) && is_near(v.y, target->height)) continue;
        throw SubjectFailure{"was given a vertex that it does not take"};
      }
    };
    Subject subject = built_in();
    subject.claims.guard_band_px = band_px;
    subject.claims.position_step_fx8 = step_fx8;
    subject.claims.named_errors = false;
    subject.draw = [=](const selvage_image* target, const selvage_rect* clip,
                       const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                       const selvage_options* options) {
      expect_near(target, vertices, count);
      return selvage_draw(target, clip, vertices, count, texture, options);
    };
    subject.draw_many = [=, many = subject.draw_many](
                            const selvage_image* target, const selvage_rect* clip,
                            const selvage_polygon* polygons, size_t count,
                            const selvage_options* options, int32_t threads, size_t* failed) {
      for (size_t i = 0; i < count; ++i)
        expect_near(target, polygons[i].vertices, polygons[i].count);
      return many(target, clip, polygons, count, options, threads, failed);
    };
    expect_to_hold(subject, 200, [](const Law& law) { return law.name == "SHIFT" ? 120 : 20; });
  }
}

// Not even to ask what it draws by.
TEST(Capabilities, AskNoClipOfASubjectWithoutClips) {
  Subject subject = built_in();
  subject.claims.clip = false;
  subject.choose = [](const selvage_image* target, const selvage_rect* clip, auto... more) {
    if (clip != nullptr) throw SubjectFailure{"was given a clip"};
    return selvage_choose(target, clip, more...);
  };
  const LawVerdict verdict = verify(*find_law("TOLERANCE"), subject, 1, 50);
  EXPECT_FALSE(verdict.violation) << explain(*verdict.violation);
  EXPECT_GT(verdict.judged_px, 0u);
}

TEST(Capabilities, TakeSomeLawsTheirSay) {
  Capabilities few;
  few.clip = few.named_errors = false;
  few.most_vertices = 3;
  few.formats = only(SELVAGE_INDEX8);
  for (const char* law : {"CLIP", "TOTAL", "IDENTITY", "FILTER"}) {
    EXPECT_EQ(promise(SELVAGE_PROFILE_EXACT, {}, law).standing, Standing::kPromised);
    EXPECT_EQ(promise(SELVAGE_PROFILE_EXACT, few, law).standing, Standing::kNotPromised);
    EXPECT_FALSE(promise(SELVAGE_PROFILE_EXACT, few, law).note.empty());
  }
  EXPECT_EQ(promise(SELVAGE_PROFILE_DKIT, few, "PART").note,
            promise(SELVAGE_PROFILE_DKIT, "PART").note);
}

// The built-in mapper, asked for less, holds all laws that are left, and each has its say.
TEST(CapabilitiesAtLength, LeaveARightMapperRight) {
  for (const Capabilities& claims : some_claims()) {
    Subject subject = built_in();
    subject.claims = claims;
    for (const Law& law : laws()) {
      if (promise(subject.profile, claims, law.name).standing != Standing::kPromised) continue;
      if (law.name == "TOTAL" && claims.filters != Capabilities{}.filters) continue;  // it has all
      const LawVerdict verdict = verify(law, subject, 1, 100);
      EXPECT_FALSE(verdict.violation) << explain(*verdict.violation);
      EXPECT_GT(verdict.judged_px, 0u) << law.name;
      for (const auto& [what, cases] : verdict.not_claimed) {
        // Laws that move or make texture coordinates leave the texture often, and a polygon that
        // fills its target cannot be shifted.
        EXPECT_LE(cases, claims.outside_texels && claims.guard_band_px > 100 ? 20u : 60u)
            << law.name << " is left out for " << what;
      }
    }
  }
}

TEST(SubjectFailure, IsAViolationOfTheLawThatIsChecked) {
  Subject subject = built_in();
  int begun = 0;
  subject.begin_case = [&] { ++begun; };
  subject.draw = [](auto...) -> selvage_status { throw SubjectFailure{"fell over"}; };
  for (const char* name : {"COV", "SAME", "TOTAL"}) {
    const LawVerdict verdict = verify(*find_law(name), subject, 1, 10);
    ASSERT_TRUE(verdict.violation);
    EXPECT_EQ(verdict.violation->law, name);
    EXPECT_EQ(verdict.violation->drawn, "it fell over");
  }
  EXPECT_GT(begun, 3);
}

// Each hang costs a person time: a few are enough to shrink by.
TEST(SubjectFailure, OfAHangIsShrunkInFewSteps) {
  Subject subject = built_in();
  int calls = 0;
  subject.draw = [&](auto...) -> selvage_status {
    ++calls;
    throw SubjectFailure{"hung", true};
  };
  EXPECT_TRUE(verify(*find_law("COV"), subject, 1, 10).violation);
  EXPECT_LE(calls, 6);
}

TEST(Margin, IsTheLeastOfTheReachThatItTakes) {
  const Reaching reach{Rational(5, 2), Rational(2), Rational(1)};  // [1/2, 7/2]
  const auto share = [&](int32_t texel, int32_t size, selvage_address address) {
    const auto margin = margin_along(reach, texel, size, address);
    return margin ? margin->share() : -1;
  };
  EXPECT_EQ(share(2, 8, SELVAGE_ADDRESS_CLAMP), 0);
  EXPECT_EQ(share(1, 8, SELVAGE_ADDRESS_CLAMP), 0.25);
  EXPECT_EQ(share(3, 8, SELVAGE_ADDRESS_CLAMP), 0.5);
  EXPECT_EQ(share(1, 2, SELVAGE_ADDRESS_CLAMP), 0) << "the last texel goes on";
  EXPECT_EQ(share(0, 3, SELVAGE_ADDRESS_WRAP), 0.5) << "texel 3, not 0";
  EXPECT_FALSE(margin_along({Rational(5, 2), 0, 0}, 2, 8, SELVAGE_ADDRESS_CLAMP));
}

TEST(Margin, IsTheSameInWhicheverOrderTheyCome) {
  constexpr Margin none{0, 0.5}, none_of_more{0, 2}, half{1, 2}, half_of_less{0.25, 0.5};
  // Quotients are rounded: one share, of two errors.
  constexpr Margin two_thirds{0x1.8000000000001p-1, 1.5}, a_bit_more{0x1.8000000000002p-1, 1.5};
  static_assert(two_thirds.measured / 1.5 == a_bit_more.measured / 1.5);
  const auto nearest = [](const Margin& first, const Margin& second) {
    std::optional<Margin> margin;
    for (const Margin& each : {first, second}) add(&margin, each);
    add(&margin, std::nullopt);
    return std::pair(margin->measured, margin->bound);
  };
  for (const auto& [less, more] :
       {std::pair(none, none_of_more), std::pair(half_of_less, half),
        std::pair(none_of_more, half_of_less), std::pair(two_thirds, a_bit_more)}) {
    EXPECT_EQ(nearest(less, more), std::pair(more.measured, more.bound));
    EXPECT_EQ(nearest(more, less), std::pair(more.measured, more.bound));
  }
}

}  // namespace
}  // namespace selvage::spec
