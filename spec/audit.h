// Audits of verifiers: does a law look at every pixel that it should, and say so?
//
// A law that looks at too little passes every mapper. So the audit counts by itself the pixels that
// are due, and then draws once for each of them with a mapper that is wrong in that pixel alone:
// the law must say that it judged so many, and reject every one of these mappers. Nor may it be
// content with a picture in which nothing is drawn.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "spec/laws.h"

namespace selvage::spec {

struct Audit {
  uint64_t due_px = 0;         // pixels that the law has to judge, by the audit's own count
  bool due_exactly = true;     // or at least so many
  uint64_t judged_px = 0;      // as the law says, of a mapper that is right
  uint64_t due_drawn_px = 1;   // to be drawn by that mapper, in all calls together, at least
  uint64_t drawn_px = 0;       // by that mapper, in all that the law made it draw
  bool rejects_right = false;  // that mapper
  std::optional<std::string> missed{};  // a wrong pixel that was not noticed, the first of them

  [[nodiscard]] bool is_passed() const {
    return due_px > 0 && (due_exactly ? judged_px == due_px : judged_px >= due_px) &&
           drawn_px >= due_drawn_px && !rejects_right && !missed;
  }
};

// What the mappers claim of what they draw, each in 1/65536: texel, px.
struct Accuracy {
  int32_t texels_fx16 = 0, coverage_fx16 = 0;
};

using Check = std::function<Judgement(const Subject&, const Case&)>;

// Of a verifier that claims to check the named law, which is promised by the case's profile. The
// case has a small target, for it is drawn several times for each pixel, and shows the law all that
// it judges:
//   TOTAL, a refused outline; all others, one that is drawn
//   CLIP and MEM, a clip; all others, none
//   PART, three vertices; SPLIT, four that are convex
//   MIRROR, a triangle without a vertex half way between pixels or an edge through a centre
//   ORACLE, q that differ
// PINWHEEL and VERT look where Case::choice says: they are asked again and again until they have
// looked everywhere. The mappers claim this accuracy: what is promised of the law then is due; that
// of coverage is to leave no pixel of the case in doubt.
[[nodiscard]] Audit audit(std::string_view law, const Check& check, const Case& c,
                          const Accuracy& accuracy = {});

}  // namespace selvage::spec
