// Profiles: the conventions a mapper may promise, and which laws each of them does.
//
// They are never mixed: a case names its profile, and every law judges it by that one.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "spec/case.h"
#include "spec/geometry.h"

namespace selvage::spec {

struct Profile {
  selvage_profile id;
  std::string_view name;       // as on the command line
  std::string_view statement;  // one sentence
  int32_t sample_fx8;          // pixel (i, j) is sampled at (256 i + sample, 256 j + sample)
  int32_t rounding_fx16;       // the texel of u is floor(u + rounding)
  bool whole_px;               // x and y must be whole pixels, and all q equal
  bool clockwise_only;         // the other winding draws nothing
  bool both_ends;              // the last column of a span and the last row are drawn too
};

// In the order of their numbers, `exact` first.
[[nodiscard]] std::span<const Profile> profiles();
// The id must be one of theirs.
[[nodiscard]] const Profile& profile_of(selvage_profile id);
[[nodiscard]] inline const Profile& profile_of(const Case& c) { return profile_of(c.profile); }
[[nodiscard]] const Profile* find_profile(std::string_view name);

// A law that this specification has, whether or not this build does.
[[nodiscard]] bool is_law_name(std::string_view law);

// How a law stands with a profile.
enum class Standing {
  kPromised,
  kNotPromised,  // and some case breaks it
  kNoMatter      // it says nothing about the profile
};
struct Promise {
  Standing standing;
  std::string_view note;  // how much of the law is promised, or why it is not; empty if all of it
};
[[nodiscard]] Promise promise(selvage_profile id, std::string_view law);
[[nodiscard]] inline bool is_promised(selvage_profile id, std::string_view law) {
  return promise(id, law).standing == Standing::kPromised;
}

// Where the pixel is sampled.
[[nodiscard]] inline Point sample_point(const Profile& profile, int32_t x_px, int32_t y_px) {
  return {int64_t{x_px} * SELVAGE_SUBPIXELS + profile.sample_fx8,
          int64_t{y_px} * SELVAGE_SUBPIXELS + profile.sample_fx8};
}

// The same scene as a profile can take it. Positions move by the difference of the sample points,
// and then to a whole pixel; u and v by the difference of the roundings, as far as 32 bits go; q is
// dropped; an outline that runs counter-clockwise is turned round where it would draw nothing. Ties
// stay ties. A case that is not of the exact profile is returned as it is.
[[nodiscard]] Case in_profile(const Case& exact, selvage_profile id);

// The same for a case of any profile: by way of the exact one, to which the moves are undone.
[[nodiscard]] Case to_profile(const Case& c, selvage_profile id);

// The vertices alone as the profile accepts them: x and y down to whole pixels, q dropped. Nothing
// changes where they are accepted.
void make_acceptable(const Profile& profile, std::span<selvage_vertex> vertices);
// Reverses an outline that runs counter-clockwise where such a one draws nothing.
void make_visible(const Profile& profile, std::vector<selvage_vertex>* vertices);

}  // namespace selvage::spec
