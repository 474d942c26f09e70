// What a subject claims to be able to do, beside its profile; by default everything.
//
// It is never asked for more: generated cases are brought within the claims, and a drawing that a
// law makes of them and that is still beyond is not judged but counted (verify.h).
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "spec/case.h"
#include "spec/profiles.h"

namespace selvage::spec {

enum class Winding : int32_t { kBoth, kClockwise, kCounterClockwise };

// Of selvage_format, selvage_filter, selvage_address: value i is bit 1 << i.
using ValueSet = uint32_t;
[[nodiscard]] constexpr ValueSet only(int32_t value) { return ValueSet{1} << value; }
[[nodiscard]] constexpr bool holds(ValueSet set, int32_t value) { return (set >> value & 1) != 0; }

inline constexpr int32_t kAnyNumber = std::numeric_limits<int32_t>::max();

struct Capabilities {
  Winding winding = Winding::kBoth;
  ValueSet formats = only(SELVAGE_INDEX8) | only(SELVAGE_RGB565) | only(SELVAGE_RGBA8888);
  ValueSet filters = only(SELVAGE_FILTER_NEAREST) | only(SELVAGE_FILTER_FOUR) |
                     only(SELVAGE_FILTER_BILINEAR) | only(SELVAGE_FILTER_AREA);  // nearest always
  ValueSet addresses = only(SELVAGE_ADDRESS_CLAMP) | only(SELVAGE_ADDRESS_WRAP);
  bool perspective = true;                  // q that differ
  bool clip = true;                         // a clip rectangle other than none
  bool negative_pitch = true;               // pictures stored bottom row first
  bool concave = true;                      // y-monotone outlines that are not convex
  bool named_errors = true;                 // bad arguments get the status that they should
  bool any_texture_side = true;             // textures whose sides are no powers of two
  bool outside_texels = true;               // vertices whose u, v lie beyond the texture
  int32_t longest_side_px = kAnyNumber;     // of the target
  int32_t longest_side_texel = kAnyNumber;  // of the texture
  int32_t most_vertices = kAnyNumber;       // at least 3
  int32_t position_step_fx8 = 1;            // x, y are multiples of it, a power of two up to 1 px
  int32_t coordinate_step_fx16 = 1;         // u, v likewise, up to 1 texel
  int32_t guard_band_px = kAnyNumber;       // how far beyond the target x, y may lie
  int32_t accuracy_fx16 = 0;                // of the exact profile: how far u and v may be off
  int32_t coverage_accuracy_fx16 = 0;       // and the outline, in x and in y, up to 1 px

  friend bool operator==(const Capabilities&, const Capabilities&) = default;
};

// What in the case is beyond the claims, in words: the first thing found.
[[nodiscard]] std::optional<std::string> beyond(const Capabilities& claims, const Case& c);

// Whether its texels are the exact ones: otherwise two drawings of one place may differ by them.
[[nodiscard]] constexpr bool shows_exact_texels(const Capabilities& claims) {
  return claims.accuracy_fx16 == 0;
}
// Its coverage, too.
[[nodiscard]] constexpr bool draws_exactly(const Capabilities& claims) {
  return shows_exact_texels(claims) && claims.coverage_accuracy_fx16 == 0;
}

// The case as the subject can take it: other formats, filters and address modes become claimed
// ones, in turn by Case::choice; q are made equal; clip and negative pitches are left out; sides
// are cut, and those of textures made powers of two; u and v are brought into the texture, x and y
// into the guard band; outlines become their convex hull, with as many corners as are drawn, in the
// right winding. What is within the claims stays as it is, and so does an outline that must be
// refused by a subject that names no errors: it cannot be mapped.
[[nodiscard]] Case within(const Capabilities& claims, const Case& c);

// The vertices alone as the profile and the subject accept them: x, y, u, v down to their steps.
// Nothing changes where they are accepted.
void make_acceptable(const Profile& profile, const Capabilities& claims,
                     std::span<selvage_vertex> vertices);
// From one x or y that both accept to the next.
[[nodiscard]] int32_t position_step_fx8(const Profile& profile, const Capabilities& claims);
// The same, no shorter than from one u or v to the next at a texel a pixel.
[[nodiscard]] int32_t mapped_step_fx8(const Profile& profile, const Capabilities& claims);

// No vertex lies further beyond the case's target than the subject takes it.
[[nodiscard]] bool lies_in_guard_band(const Capabilities& claims, const Case& c);
// Moves those that do to its border.
void take_into_guard_band(const Capabilities& claims, Case* c);
// x or y, in 1/256 px, of a target so long in its direction.
[[nodiscard]] int32_t in_guard_band(const Capabilities& claims, int32_t at_fx8, int32_t side_px);

// Reverses an outline that the profile or the subject would not draw this way round.
void make_visible(const Profile& profile, const Capabilities& claims,
                  std::vector<selvage_vertex>* vertices);

}  // namespace selvage::spec
