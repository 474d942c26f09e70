// What the laws share: variations of a case, and the comparison of pictures.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "spec/exact.h"
#include "spec/geometry.h"
#include "spec/laws.h"
#include "spec/model.h"
#include "spec/picture.h"
#include "spec/profiles.h"
#include "spec/texel_reach.h"

namespace selvage::spec {

// A stream of small choices out of Case::choice: the same case always gives the same ones.
class Choices {
 public:
  explicit Choices(uint32_t choice) : state_(choice) {}
  // In [least, end).
  [[nodiscard]] int32_t pick(int32_t least, int32_t end);

 private:
  uint64_t state_;
};

// A pixel of the target, so far from the end of the vertex range that a polygon fits around it.
[[nodiscard]] Pixel choose_pixel(const Case& c, Choices& choices);

// Where the case's profile samples it.
[[nodiscard]] inline Point sample_point(const Case& c, Pixel pixel) {
  return sample_point(profile_of(c), pixel.x_px, pixel.y_px);
}

// The case as the laws that read texels back draw it: a mixed pixel tells no texel.
[[nodiscard]] Case with_nearest(const Case& c);

// A texture of other sides, which are no longer and powers of two if they were.
void take_other_texture_size(Case* c);

// Whether the clip leaves the pixel in.
[[nodiscard]] inline bool is_visible(const Case& c, Pixel at) {
  return !c.has_clip || (c.clip.left <= at.x_px && at.x_px < c.clip.right &&
                         c.clip.top <= at.y_px && at.y_px < c.clip.bottom);
}

// A vertex at another place.
[[nodiscard]] inline selvage_vertex vertex_at(Point p, const selvage_vertex& like) {
  return {static_cast<int32_t>(p.x), static_cast<int32_t>(p.y), like.u, like.v, like.q};
}

// The case with another outline, made acceptable to the profile and the subject, and with a filter
// that profile and format allow.
[[nodiscard]] Case with_vertices(const Capabilities& claims, const Case& c,
                                 std::vector<selvage_vertex> vertices);

// The case with its own outline made acceptable: for laws that make other outlines of it.
[[nodiscard]] inline Case acceptable(const Capabilities& claims, const Case& c) {
  return with_vertices(claims, c, c.vertices);
}

// The case with its outline the way round that its profile and the subject draw.
[[nodiscard]] Case visible(const Subject& subject, Case c);

// Moves by whole units; empty if a vertex would leave the accepted range.
[[nodiscard]] std::optional<std::vector<selvage_vertex>> moved(
    std::span<const selvage_vertex> vertices, int64_t dx_fx8, int64_t dy_fx8);

// The same, empty too where the subject does not take them so far from the case's target.
[[nodiscard]] std::optional<std::vector<selvage_vertex>> moved_in_band(const Capabilities& claims,
                                                                       const Case& c,
                                                                       int64_t dx_fx8,
                                                                       int64_t dy_fx8);

// The exact coordinates at a pixel as text, for a violation; empty if it is not covered.
void tell_coordinates(Violation* violation, const Case& shown, int32_t x_px, int32_t y_px);

// The four channels of a pixel that mixes texels.
[[nodiscard]] std::string describe_colour(uint32_t pixel);
[[nodiscard]] std::string describe_pixel(const Case& c, const std::optional<uint32_t>& pixel);

[[nodiscard]] Violation violation_at(std::string_view law, std::string what, const Case& shown,
                                     int32_t x_px, int32_t y_px, std::string allowed,
                                     const std::optional<uint32_t>& drawn);
[[nodiscard]] Violation violation_of_call(std::string_view law, std::string what, const Case& shown,
                                          std::string allowed, std::string drawn);

// Whether a pixel of a drawing may be there or not, by a subject whose outlines may be so far off:
// it is visible, and its sample point lies no further from the outline.
[[nodiscard]] bool is_in_doubt(int32_t coverage_accuracy_fx16, const Case& shown, Pixel at);

// How far the outline would have to be off for the pixel to be as it was drawn, where it is not as
// the model has it.
void tell_outline_offset(Violation* violation, bool is_drawn);

using MaybePixel = std::optional<uint32_t>;

// What a law demands at a pixel.
struct Wanted {
  bool judged;
  MaybePixel pixel;  // nothing: the pixel must not be drawn
};
[[nodiscard]] inline Wanted must_be(const MaybePixel& pixel) { return {true, pixel}; }
[[nodiscard]] inline Wanted unjudged() { return {false, {}}; }

// Compares picture (drawn for `shown`) with what is wanted at each pixel of its target.
using WantedAt = std::function<Wanted(int32_t x_px, int32_t y_px)>;
// But for pixels that are not as wanted where that is in doubt.
[[nodiscard]] WantedAt without_doubt(int32_t coverage_accuracy_fx16, const Case& shown,
                                     const Picture& picture, WantedAt wanted_at);
[[nodiscard]] Judgement compare(std::string_view law, std::string_view what, const Case& shown,
                                const Picture& picture, const WantedAt& wanted_at);

// The same where another drawing tells what is wanted: a clause that says so, "the whole polygon
// shows it"; whether both show texels of the coordinate texture; whether these are judged, or
// coverage alone: then one texel is as good as another.
struct OtherDrawing {
  std::string_view clause;
  bool shows_texels = true;
  bool judges_texels = true;
  int32_t coverage_accuracy_fx16 = 0;  // of both; what is in doubt is not judged
};
// By the same subject: where it claims no exact texels or coverage, two drawings may differ in
// them.
[[nodiscard]] inline OtherDrawing drawing_of(const Subject& subject, std::string_view clause) {
  return {clause, true, shows_exact_texels(subject.claims), subject.claims.coverage_accuracy_fx16};
}
[[nodiscard]] Judgement compare(std::string_view law, std::string_view what, const Case& shown,
                                const Picture& picture, const OtherDrawing& other,
                                const WantedAt& wanted_at);

// Adds up the pixels and keeps the first violation and the nearest margin; true if there is one.
bool add(Judgement* total, Judgement part);

}  // namespace selvage::spec
