#include "spec/promise.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace selvage::spec {
namespace {

// How much of a law is promised by a subject whose coverage is within its accuracy alone.
[[nodiscard]] Promise of_inexact_coverage(std::string_view law, const Promise& limited) {
  constexpr std::string_view kWithin = "within the accuracy of its coverage";
  constexpr std::string_view kNear = "but for pixels within its accuracy of the outline";
  const std::pair<std::string_view, std::string_view> parts[] = {
      {"COV", kWithin},
      {"PART", "shared edges exactly; the outline within the accuracy of its coverage"},
      {"PINWHEEL", "where the vertex is further from the others' outline than its accuracy"},
      {"CLIP", kNear},
      {"GAMUT", kNear},
      {"SHIFT", kNear},
      {"ORDER", kNear},
      {"MIRROR", kNear},
      {"SPLIT", "shared edges exactly; the outline within the accuracy of its coverage"},
      {"IDENTITY", kNear},
      {"AFFINE", kNear},
      {"TOLERANCE", kNear},
      {"SAME", "each drawing within its accuracy"},
  };
  const auto part =
      std::ranges::find(parts, law, &std::pair<std::string_view, std::string_view>::first);
  if (part == std::end(parts) || !limited.note.empty()) return limited;
  return {Standing::kPromised, part->second};
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
  const Promise of_texels =
      shows_exact_texels(claims) ? limited : of_inexact_texels(law, claims, limited);
  return claims.coverage_accuracy_fx16 == 0 ? of_texels : of_inexact_coverage(law, of_texels);
}

}  // namespace selvage::spec
