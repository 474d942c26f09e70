// The laws: what a mapper promises; spec/profiles.h tells how much of it each profile does.
// spec/README.md states and numbers them.
//
// A law is a pure function of a subject and a case. It draws what it needs, judges what it saw, and
// returns how many pixels it judged and the first violation, if any. A law never trusts the
// subject: expectations come from the exact model (spec/exact.h) or from a second drawing.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "spec/case.h"
#include "spec/picture.h"
#include "spec/subject.h"

namespace selvage::spec {

// Two drawings of one target that a law held against each other.
struct Comparison {
  Picture drawn, wanted;     // alike where nothing is judged
  bool shows_texels = true;  // by the coordinate texture, if the filter is nearest
};

// How far (u, v) would have to be moved, at the least, to come to a texel.
struct Offset {
  double u_texel = 0, v_texel = 0;
};

struct Violation {
  std::string law{};
  std::string what{};              // one sentence: what should have held
  int32_t x_px = -1, y_px = -1;    // the pixel, or -1, -1 where no single pixel is to blame
  std::string u{}, v{};            // exact coordinates there, texels, as fractions; may be empty
  std::string allowed{};           // what the law allows there
  std::optional<Offset> off_by{};  // from there to the texel that was drawn, if it is not in place
  std::optional<double> off_by_px{};  // from the sample to the outline that is on its wrong side
  std::string scene{};                // what else was drawn besides the shown case; empty: nothing
  std::string drawn{};                // what the subject drew
  Case shown{};             // the drawing in which it was seen, derived from the law's case
  bool is_of_call = false;  // a call did not end as calls do: whatever the law, it says the same
  // Where another drawing told what is allowed, and not the model.
  std::shared_ptr<const Comparison> comparison{};
};

// How near a law with a bound came to it. Laws without one are exact.
struct Margin {
  double measured = 0, bound = 1;  // in the same unit

  [[nodiscard]] double share() const { return measured / bound; }
};

struct Judgement {
  uint64_t judged_px = 0;  // pixels (for TOTAL: calls too) on which the law had its say
  std::optional<Violation> violation{};
  std::optional<Margin> margin{};            // the one nearest to its bound
  std::optional<std::string> not_claimed{};  // what the subject does not claim: nothing is judged
};

struct Law {
  std::string_view name;       // as in the table of spec/README.md
  std::string_view statement;  // one sentence
  Judgement (*check)(const Subject& subject, const Case& c);
};

// In the order of spec/README.md. ORACLE is among them where the build found OpenCV.
[[nodiscard]] std::span<const Law> laws();
[[nodiscard]] const Law* find_law(std::string_view name);

// Several lines for a terminal: law, sentence, pixel, exact (u, v), allowed, drawn, the drawing.
[[nodiscard]] std::string explain(const Violation& violation);

}  // namespace selvage::spec
