#include "spec/laws.h"

#include <array>

#include "spec/law_list.h"

namespace selvage::spec {
namespace {

constexpr std::array kLaws = {
    Law{"COV", "the covered set is the specification's", check_cov},
    Law{"PART", "polygons that tile a region cover each of its pixels once and no other",
        check_part},
    Law{"PINWHEEL", "of triangles that meet in a vertex on a sample point exactly one owns it",
        check_pinwheel},
    Law{"CLIP", "drawing clipped is drawing whole, then cropping", check_clip},
    Law{"VERT", "the mapping at a vertex is that vertex's, on a shared edge both sides agree",
        check_vert},
    Law{"MAP", "each texel drawn is the exact one, or within the profile's derived bound of it",
        check_map},
    Law{"DDA", "each texel drawn is that of the profile's arithmetic, bit for bit", check_dda},
    Law{"GAMUT", "u and v stay within the polygon's own range, and in the texture", check_gamut},
    Law{"SHIFT", "shifting by whole pixels or whole texels shifts the picture", check_shift},
    Law{"ORDER", "neither the first vertex nor the winding matters", check_order},
    Law{"MIRROR", "flips and quarter turns flip and turn the picture, ties apart", check_mirror},
    Law{"SPLIT", "cutting along a chord changes nothing", check_split},
    Law{"IDENTITY", "an axis-aligned one-to-one polygon is a block copy", check_identity},
    Law{"AFFINE", "equal q is no q, and projective maps keep cross-ratios", check_affine},
    Law{"FILTER", "a filtered pixel is its formula's mean, and a constant texture stays constant",
        check_filter},
    Law{"MEM", "nothing but the target's visible pixels is written", check_mem},
    Law{"TOTAL", "every input gets a picture or a named error, and an error draws nothing",
        check_total},
    Law{"SAME",
        "every order of tiles, every number of threads and every kernel draws the same bytes",
        check_same},
#ifdef SELVAGE_WITH_OPENCV
    Law{"ORACLE", "the mapper agrees with OpenCV wherever OpenCV is decided", check_oracle},
#endif
};

}  // namespace

std::span<const Law> laws() { return kLaws; }

const Law* find_law(std::string_view name) {
  for (const Law& law : kLaws) {
    if (law.name == name) return &law;
  }
  return nullptr;
}

std::string explain(const Violation& violation) {
  std::string text = "law " + violation.law + " is broken: " + violation.what + "\n";
  if (violation.x_px >= 0) {
    text += "  pixel    (" + std::to_string(violation.x_px) + ", " +
            std::to_string(violation.y_px) + ")\n";
  }
  if (!violation.u.empty()) {
    text += "  exact u  " + violation.u + "\n  exact v  " + violation.v + "\n";
  }
  text += "  allowed  " + violation.allowed + "\n  drawn    " + violation.drawn + "\n";
  return text + print(violation.shown);
}

}  // namespace selvage::spec
