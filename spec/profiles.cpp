#include "spec/profiles.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <ranges>

#include "spec/vertex_units.h"

namespace selvage::spec {
namespace {

constexpr std::array kProfiles = {
    Profile{
        SELVAGE_PROFILE_EXACT, "exact",
        "pixels sampled at their centres, half-open, each showing the texel that holds the exact "
        "(u, v)",
        SELVAGE_SUBPIXELS / 2, 0, false, false, false},
    Profile{SELVAGE_PROFILE_ABRASH56, "abrash56",
            "two-stage 16.16 DDA between edges at ceil(x), truncated; clockwise only", 0, 0, true,
            true, false},
    Profile{SELVAGE_PROFILE_ABRASH57, "abrash57",
            "as abrash56, the source prestepped by half a step and rounded", 0,
            SELVAGE_SUBTEXELS / 2, true, true, false},
    Profile{SELVAGE_PROFILE_DKIT, "dkit",
            "edges and their texels rounded, both ends drawn, the texels between them rounded", 0,
            SELVAGE_SUBTEXELS / 2, true, false, true},
};

struct Entry {
  std::string_view law;
  std::array<Promise, 4> by_profile;  // in the order of kProfiles
};

constexpr Promise kYes{Standing::kPromised, ""};
constexpr Promise yes(std::string_view how_much) { return {Standing::kPromised, how_much}; }
constexpr Promise no(std::string_view why) { return {Standing::kNotPromised, why}; }
constexpr Promise none(std::string_view why) { return {Standing::kNoMatter, why}; }

constexpr std::string_view kEnds = "both ends are drawn: on a shared edge pixels are drawn twice";
constexpr std::string_view kCoverage = "the coverage; the texels depend on where an edge starts";
constexpr std::string_view kSteps = "within a bound derived from rows and pixels walked, and du/dx";
constexpr std::string_view kRoundings = "within half a texel and half a pixel's du/dx";
constexpr std::string_view kDirected =
    "truncation, and samples in a pixel's corner, have a direction";
constexpr std::string_view kAffineOnly = "equal q; others are refused";
constexpr std::string_view kOtherSamples = "OpenCV samples elsewhere and steps no edges";

constexpr std::string_view kNoTolerance = "tolerance is nothing to it; MAP has its bound";
constexpr std::string_view kNoFilters = "it knows no filters; DDA judges the nearest texel";

constexpr std::array kPromises = {
    Entry{"COV", {kYes, kYes, kYes, kYes}},
    Entry{"PART", {kYes, kYes, kYes, no(kEnds)}},
    Entry{"PINWHEEL", {kYes, kYes, kYes, no(kEnds)}},
    Entry{"CLIP", {kYes, kYes, kYes, kYes}},
    Entry{"VERT",
          {kYes, yes("at vertices; along edges MAP's bound holds"),
           no("the prestep leaves every vertex by half a step"),
           no("a span of one pixel shows one of its two ends")}},
    Entry{"MAP", {kYes, yes(kSteps), yes(kSteps), yes(kRoundings)}},
    Entry{"DDA", {none("its arithmetic is its own affair: MAP judges it"), kYes, kYes, kYes}},
    Entry{"GAMUT", {kYes, kYes, kYes, kYes}},
    Entry{"SHIFT", {kYes, kYes, kYes, kYes}},
    Entry{"ORDER",
          {kYes, yes("which vertex comes first; the other winding draws none of the pixels"),
           yes("which vertex comes first; the other winding draws none of the pixels"), kYes}},
    Entry{"MIRROR", {kYes, no(kDirected), no(kDirected), no(kDirected)}},
    Entry{"SPLIT", {kYes, yes(kCoverage), yes(kCoverage), no(kEnds)}},
    Entry{"IDENTITY", {kYes, kYes, yes("of as many texel centres as pixels"), kYes}},
    Entry{"AFFINE", {kYes, yes(kAffineOnly), yes(kAffineOnly), yes(kAffineOnly)}},
    Entry{"FILTER", {kYes, none(kNoFilters), none(kNoFilters), none(kNoFilters)}},
    Entry{"TOLERANCE", {kYes, none(kNoTolerance), none(kNoTolerance), none(kNoTolerance)}},
    Entry{"MEM", {kYes, kYes, kYes, kYes}},
    Entry{"TOTAL", {kYes, kYes, kYes, kYes}},
    Entry{"SAME", {kYes, kYes, kYes, kYes}},
    Entry{"ORACLE", {kYes, no(kOtherSamples), no(kOtherSamples), no(kOtherSamples)}},
};

[[nodiscard]] int32_t to_whole_px(int32_t position_fx8) {
  return position_fx8 & ~(SELVAGE_SUBPIXELS - 1);
}

}  // namespace

std::span<const Profile> profiles() { return kProfiles; }

const Profile& profile_of(selvage_profile id) { return kProfiles[static_cast<size_t>(id)]; }

const Profile* find_profile(std::string_view name) {
  const auto found = std::ranges::find(kProfiles, name, &Profile::name);
  return found != kProfiles.end() ? &*found : nullptr;
}

bool is_law_name(std::string_view law) {
  return std::ranges::find(kPromises, law, &Entry::law) != kPromises.end();
}

Promise promise(selvage_profile id, std::string_view law) {
  const auto found = std::ranges::find(kPromises, law, &Entry::law);
  if (found == kPromises.end()) return none("no law is called so");
  return found->by_profile[static_cast<size_t>(id)];
}

void make_acceptable(const Profile& profile, std::span<selvage_vertex> vertices) {
  if (!profile.whole_px) return;
  for (selvage_vertex& v : vertices) {
    v.x = to_whole_px(v.x);
    v.y = to_whole_px(v.y);
    v.q = vertices.front().q;
  }
}

void make_visible(const Profile& profile, std::vector<selvage_vertex>* vertices) {
  if (profile.clockwise_only && doubled_area(*vertices) < 0) std::ranges::reverse(*vertices);
}

Case in_profile(const Case& exact, selvage_profile id) {
  const Profile& profile = profile_of(id);
  if (exact.profile != SELVAGE_PROFILE_EXACT || !profile.whole_px) return exact;
  Case c = exact;
  c.profile = id;
  c.filter = SELVAGE_FILTER_NEAREST;
  // A centre at 1/2 goes to 0, and the nearest whole pixel to x - 1/2, halves upward, is floor(x).
  static_assert(kProfiles[0].sample_fx8 == SELVAGE_SUBPIXELS / 2);
  make_acceptable(profile, c.vertices);
  for (selvage_vertex& v : c.vertices) {
    v.u = clamped_coordinate(int64_t{v.u} - profile.rounding_fx16);
    v.v = clamped_coordinate(int64_t{v.v} - profile.rounding_fx16);
  }
  make_visible(profile, &c.vertices);
  return c;
}

Case to_profile(const Case& c, selvage_profile id) {
  if (c.profile == id) return c;
  const Profile &from = profile_of(c), &exact = profile_of(SELVAGE_PROFILE_EXACT);
  const int32_t down_fx8 = from.sample_fx8 - exact.sample_fx8;
  const int32_t down_fx16 = from.rounding_fx16 - exact.rounding_fx16;
  Case undone = c;
  undone.profile = SELVAGE_PROFILE_EXACT;
  for (selvage_vertex& v : undone.vertices) {
    for (int32_t* at : {&v.x, &v.y}) *at = clamped_position(int64_t{*at} - down_fx8);
    for (int32_t* at : {&v.u, &v.v}) *at = clamped_coordinate(int64_t{*at} + down_fx16);
  }
  return in_profile(undone, id);
}

}  // namespace selvage::spec
