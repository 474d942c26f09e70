#include "spec/laws.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <utility>

#include "spec/law_list.h"
#include "spec/law_tools.h"
#include "spec/refusal.h"
#include "spec/sample_place.h"
#include "spec/status_name.h"

namespace selvage::spec {
namespace {

[[nodiscard]] Judgement refused(const Refusal& refusal, std::string_view law) {
  Violation violation =
      violation_of_call(law, "a valid polygon is drawn, and the call answers so", refusal.shown,
                        status_name(SELVAGE_OK),
                        "it returned " + status_name(refusal.status) + " for a valid polygon; " +
                            status_name(SELVAGE_OK) + " is right");
  violation.is_of_call = true;
  return {.judged_px = 1, .violation = std::move(violation)};
}

[[nodiscard]] std::string_view name_of(Judgement (*check)(const Subject&, const Case&)) {
  return std::ranges::find(laws(), check, &Law::check)->name;
}

// A law's check, by which a refusal of what must be drawn is a violation of it.
template <Judgement (*kCheck)(const Subject&, const Case&)>
[[nodiscard]] Judgement held(const Subject& subject, const Case& c) {
  try {
    return kCheck(subject, c);
  } catch (const Refusal& refusal) {
    return refused(refusal, name_of(held<kCheck>));
  }
}

// A fraction that nobody can read at a glance is told in decimals, too: from the next whole number
// where it is near it, for that side decides.
[[nodiscard]] std::string with_decimals(const std::string& fraction) {
  constexpr double kNear_texel = 0.001;
  Rational number;  // it may come from a file
  if (number.set_str(fraction, 10) != 0 || number.get_den() < 100) return fraction;
  number.canonicalize();
  if (abs(number) >= std::numeric_limits<int32_t>::max()) return fraction;
  const int32_t next = floor(number + Rational(1, 2));
  const double from_next = Rational(number - next).get_d();
  const double size = std::abs(from_next);
  std::ostringstream text;
  text << fraction << ", about ";
  if (size < kNear_texel) {
    text << next << (from_next < 0 ? " - " : " + ") << std::setprecision(2) << size;
  } else {
    text << std::fixed << std::setprecision(6) << number.get_d();
  }
  return text.str();
}

// Three digits are enough to tell a rounding from a prestep.
[[nodiscard]] std::string decimal_text(double texels) {
  std::ostringstream text;
  text << std::setprecision(3) << texels;
  return text.str();
}

constexpr std::array kLaws = {
    Law{"COV", "the covered set is the specification's", held<check_cov>},
    Law{"PART", "polygons that tile a region cover each of its pixels once and no other",
        held<check_part>},
    Law{"PINWHEEL", "of triangles that meet in a vertex on a sample point exactly one owns it",
        held<check_pinwheel>},
    Law{"CLIP", "drawing clipped is drawing whole, then cropping", held<check_clip>},
    Law{"VERT", "the mapping at a vertex is that vertex's, on a shared edge both sides agree",
        held<check_vert>},
    Law{"MAP", "each texel drawn is the exact one, or within the profile's derived bound of it",
        held<check_map>},
    Law{"DDA", "each texel drawn is that of the profile's arithmetic, bit for bit",
        held<check_dda>},
    Law{"GAMUT", "u and v stay within the polygon's own range, and in the texture",
        held<check_gamut>},
    Law{"SHIFT", "shifting by whole pixels or whole texels shifts the picture", held<check_shift>},
    Law{"ORDER", "neither the first vertex nor the winding matters", held<check_order>},
    Law{"MIRROR", "flips and quarter turns flip and turn the picture, ties apart",
        held<check_mirror>},
    Law{"SPLIT", "cutting along a chord changes nothing", held<check_split>},
    Law{"IDENTITY", "an axis-aligned one-to-one polygon is a block copy", held<check_identity>},
    Law{"AFFINE", "equal q is no q, and projective maps keep cross-ratios", held<check_affine>},
    Law{"FILTER", "a filtered pixel is its formula's mean, and a constant texture stays constant",
        held<check_filter>},
    Law{"TOLERANCE", "within a tolerance, texels are within a derived bound, and that within it",
        held<check_tolerance>},
    Law{"MEM", "nothing but the target's visible pixels is written", held<check_mem>},
    Law{"TOTAL", "every input gets a picture or a named error, and an error draws nothing",
        held<check_total>},
    Law{"SAME",
        "every order of tiles, number of threads, kernel, layout and reuse of memory draws the "
        "same",
        held<check_same>},
#ifdef SELVAGE_WITH_OPENCV
    Law{"ORACLE", "the mapper agrees with OpenCV wherever OpenCV is decided", held<check_oracle>},
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
    if (violation.scene.empty()) {
      text +=
          "  sample   " + describe_sample(violation.shown, violation.x_px, violation.y_px) + "\n";
    }
  }
  if (!violation.u.empty()) {
    text += "  exact u  " + with_decimals(violation.u) + "\n";
    text += "  exact v  " + with_decimals(violation.v) + "\n";
  }
  if (violation.off_by) {
    text += "  off by   " + decimal_text(violation.off_by->u_texel) + " texel in u, " +
            decimal_text(violation.off_by->v_texel) + " in v\n";
  }
  if (violation.off_by_px) {
    text += "  off by   " + decimal_text(*violation.off_by_px) + " px, the outline\n";
  }
  text += "  allowed  " + violation.allowed + "\n  drawn    " + violation.drawn + "\n";
  text += print(violation.shown);
  return violation.scene.empty() ? text : text + violation.scene + "\n";
}

}  // namespace selvage::spec
