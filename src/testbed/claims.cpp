#include "testbed/claims.h"

#include <bit>
#include <string>

#include "testbed/host.h"

namespace selvage::testbed {
namespace {

[[nodiscard]] LibraryError wrong(const std::string& field, int64_t value,
                                 const std::string& right) {
  return LibraryError("its selvage_subject() has " + field + " " + std::to_string(value) + "; " +
                      right);
}

[[nodiscard]] uint32_t set_of(uint32_t said, uint32_t all, const char* field) {
  if ((said & ~all) != 0) {
    throw wrong(field, said, "a sum of 1u << value for values that selvage.h has is right");
  }
  return said != 0 ? said : all;
}

[[nodiscard]] int32_t number_of(int32_t said, int32_t least, const char* field) {
  if (said == 0) return spec::kAnyNumber;
  if (said < least) {
    throw wrong(field, said, "0, for any, or at least " + std::to_string(least) + " is right");
  }
  return said;
}

[[nodiscard]] int32_t step_of(int32_t said, int32_t most, const char* field) {
  if (said == 0) return 1;
  if (said < 0 || said > most || !std::has_single_bit(static_cast<uint32_t>(said))) {
    throw wrong(field, said,
                "0, for 1, or a power of two up to " + std::to_string(most) + " is right");
  }
  return said;
}

}  // namespace

spec::Subject claimed(const selvage_claims& claims) {
  if (claims.profile < SELVAGE_PROFILE_EXACT || claims.profile > SELVAGE_PROFILE_DKIT) {
    throw wrong("profile", claims.profile, "a selvage_profile is right");
  }
  if (claims.winding < SELVAGE_WINDING_BOTH || claims.winding > SELVAGE_WINDING_COUNTER_CLOCKWISE) {
    throw wrong("winding", claims.winding, "a selvage_winding is right");
  }
  if ((claims.lacks & ~uint32_t{SELVAGE_LACKS_ALL}) != 0) {
    throw wrong("lacks", claims.lacks, "a sum of SELVAGE_LACKS_... is right");
  }
  constexpr int32_t kMostAccuracy_fx16 = 1 << 30;
  const int32_t most = claims.profile == SELVAGE_PROFILE_EXACT ? kMostAccuracy_fx16 : 0;
  if (claims.accuracy < 0 || claims.accuracy > most) {
    throw wrong("accuracy", claims.accuracy,
                "0 is right, and in profile exact 1/65536 texel to 16384 texels");
  }
  const int32_t most_px = claims.profile == SELVAGE_PROFILE_EXACT ? SELVAGE_SUBTEXELS : 0;
  if (claims.coverage_accuracy < 0 || claims.coverage_accuracy > most_px) {
    throw wrong("coverage_accuracy", claims.coverage_accuracy,
                "0 is right, and in profile exact 1/65536 px to 1 px");
  }
  const int32_t guard_band_px = number_of(claims.guard_band_px, 1, "guard_band_px");
  const auto has = [&](uint32_t what) { return (claims.lacks & what) == 0; };
  const spec::Capabilities all;
  spec::Subject subject;
  subject.profile = claims.profile;
  subject.claims = {
      .winding = static_cast<spec::Winding>(claims.winding),
      .formats = set_of(claims.formats, all.formats, "formats"),
      .filters = set_of(claims.filters, all.filters, "filters"),
      .addresses = set_of(claims.addresses, all.addresses, "addresses"),
      .perspective = has(SELVAGE_LACKS_PERSPECTIVE),
      .clip = has(SELVAGE_LACKS_CLIP),
      .negative_pitch = has(SELVAGE_LACKS_NEGATIVE_PITCH),
      .concave = has(SELVAGE_LACKS_CONCAVE),
      .named_errors = has(SELVAGE_LACKS_NAMED_ERRORS),
      .any_texture_side = has(SELVAGE_LACKS_ANY_TEXTURE_SIDE),
      .outside_texels = has(SELVAGE_LACKS_OUTSIDE_TEXELS),
      .longest_side_px = number_of(claims.longest_side_px, 1, "longest_side_px"),
      .longest_side_texel = number_of(claims.longest_side_texel, 1, "longest_side_texel"),
      .most_vertices = number_of(claims.most_vertices, 3, "most_vertices"),
      .position_step_fx8 = step_of(claims.position_step, SELVAGE_SUBPIXELS, "position_step"),
      .coordinate_step_fx16 = step_of(claims.coordinate_step, SELVAGE_SUBTEXELS, "coordinate_step"),
      .guard_band_px = has(SELVAGE_LACKS_OUTSIDE_VERTICES) ? guard_band_px : 0,
      .accuracy_fx16 = claims.accuracy,
      .coverage_accuracy_fx16 = claims.coverage_accuracy,
  };
  if (!spec::holds(subject.claims.filters, SELVAGE_FILTER_NEAREST)) {
    throw wrong("filters", claims.filters,
                "nearest must be among them: without it no texel can be told");
  }
  return subject;
}

}  // namespace selvage::testbed
