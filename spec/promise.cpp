#include "spec/promise.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace selvage::spec {
namespace {

// How much of a law is promised by a subject whose coverage is within its accuracy alone; its
// texels are exact, or not.
[[nodiscard]] std::string_view note_of_coverage(std::string_view law, bool shows_exactly) {
  constexpr std::string_view kWithin = "within the accuracy of its coverage";
  constexpr std::string_view kNear = "but for pixels within its accuracy of the outline";
  constexpr std::string_view kNearAlone =
      "the coverage, but for pixels within its accuracy of the outline; texels are within theirs "
      "(MAP)";
  constexpr std::string_view kTiles =
      "where no tile is so thin that the accuracy of its coverage may turn it over";
  struct Note {
    std::string_view law, of_exact_texels, of_others;
  };
  const Note notes[] = {
      {"COV", kWithin, kWithin},
      {"PART", kTiles, kTiles},
      {"PINWHEEL", kTiles, kTiles},
      {"CLIP", kNear, kNearAlone},
      {"GAMUT", kNear, "within its accuracy, but for pixels that near to the outline"},
      {"SHIFT", kNear, kNearAlone},
      {"ORDER", kNear, kNearAlone},
      {"MIRROR", kNear, kNearAlone},
      {"SPLIT", kNear, kNearAlone},
      {"IDENTITY", kNear, "with the nearest filter, but for pixels near the outline"},
      {"AFFINE", kNear, kNearAlone},
      {"TOLERANCE", kNear,
       "within the tolerance and its accuracy together, but for pixels near the outline"},
      {"SAME", kNear, "each drawing within its accuracy"},
  };
  const auto note = std::ranges::find(notes, law, &Note::law);
  if (note == std::end(notes)) return {};
  return shows_exactly ? note->of_exact_texels : note->of_others;
}

// How much of a law is promised by a subject whose texels are within its accuracy alone.
[[nodiscard]] Promise of_inexact_texels(std::string_view law, const Capabilities& claims,
                                        const Promise& limited) {
  constexpr std::string_view kTexels = "within its accuracy";
  constexpr std::string_view kCoverageAlone = "the coverage; texels are within its accuracy (MAP)";
  constexpr std::string_view kOneColour = "of a texture of one colour, which stays so";
  const std::pair<std::string_view, std::string_view> parts[] = {
      {"VERT", kTexels},
      {"MAP", kTexels},
      {"GAMUT", kTexels},
      {"TOLERANCE", "within the tolerance and its accuracy together"},
      {"ORACLE", "where its accuracy leaves OpenCV no other texel"},
      {"CLIP", kCoverageAlone},
      {"SHIFT", kCoverageAlone},
      {"ORDER", kCoverageAlone},
      {"MIRROR", kCoverageAlone},
      {"SPLIT", kCoverageAlone},
      {"AFFINE", kCoverageAlone},
      {"IDENTITY", "with the nearest filter"},
      {"FILTER", claims.accuracy_fx16 < SELVAGE_SUBTEXELS ? kTexels : kOneColour},
      {"SAME", "each drawing within its accuracy"},
  };
  const auto part =
      std::ranges::find(parts, law, &std::pair<std::string_view, std::string_view>::first);
  return part == std::end(parts) ? limited : Promise{Standing::kPromised, part->second};
}

}  // namespace

Promise promise(selvage_profile id, const Capabilities& claims, std::string_view law) {
  struct Limit {
    std::string_view law;
    bool applies;
    Promise promise;
  };
  constexpr auto no = Standing::kNotPromised, part = Standing::kPromised;
  const Limit limits[] = {
      {"CLIP", !claims.clip, {no, "it does not clip"}},
      {"TOTAL", !claims.named_errors, {no, "it does not name errors"}},
      {"IDENTITY", claims.most_vertices < 4, {no, "it draws triangles alone, and no rectangle"}},
      {"FILTER",
       !holds(claims.formats, SELVAGE_RGBA8888),
       {no, "it does not draw RGBA8888, which has the channels that filters mix"}},
      {"IDENTITY",
       !claims.outside_texels,
       {no, "it lays its rectangle anywhere, mostly beyond the texture"}},
      {"SPLIT",
       !claims.outside_texels,
       {no, "it lays texture coordinates over the plane, and the texture ends"}},
      {"IDENTITY",
       claims.accuracy_fx16 >= SELVAGE_SUBTEXELS / 2,
       {no, "its texels may be off by half a texel or more"}},
      {"SAME",
       claims.accuracy_fx16 >= SELVAGE_SUBTEXELS,
       {no, "its texels may be off by a texel or more"}},
      {"ORACLE",
       claims.accuracy_fx16 >= SELVAGE_SUBTEXELS / 4,
       {no, "its texels may be off by a quarter of a texel or more, which decides little"}},
      {"PINWHEEL",
       claims.position_step_fx8 > SELVAGE_SUBPIXELS / 2,
       {no, "no vertex of its lies on a sample point"}},
      {"VERT",
       claims.position_step_fx8 > SELVAGE_SUBPIXELS / 2,
       {no, "no vertex of its lies on a sample point"}},
      {"ORDER", claims.winding != Winding::kBoth, {part, "which vertex comes first"}},
      {"SHIFT",
       !holds(claims.addresses, SELVAGE_ADDRESS_WRAP) || !claims.outside_texels,
       {part, "shifts of the polygon; those of the texture are seen in wrap mode, beyond it"}},
      {"AFFINE", !claims.perspective, {part, "equal q"}},
      {"TOLERANCE",
       !claims.clip,
       {part, "the tolerance; bounds are asked for row by row, by clips"}},
      {"SAME", !claims.clip, {part, "kernels; tiles are drawn through clip rectangles"}},
  };
  const Promise whole = promise(id, law);
  if (whole.standing != Standing::kPromised) return whole;
  const auto limit =
      std::ranges::find_if(limits, [&](const Limit& one) { return one.law == law && one.applies; });
  const Promise limited = limit == std::end(limits) ? whole : limit->promise;
  if (limited.standing != Standing::kPromised || draws_exactly(claims)) return limited;
  const bool is_exact = shows_exact_texels(claims);
  const Promise of_texels = is_exact ? limited : of_inexact_texels(law, claims, limited);
  const std::string_view note = note_of_coverage(law, is_exact);
  const bool is_told = claims.coverage_accuracy_fx16 > 0 && limited.note.empty() && !note.empty();
  return is_told ? Promise{Standing::kPromised, note} : of_texels;
}

}  // namespace selvage::spec
