// The laws are verifiers, and verifiers can be wrong: one that looks at nothing, or in the wrong
// place, passes every mapper. The audit must tell such ones from the laws.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "spec/audit.h"
#include "spec/generate.h"
#include "spec/model.h"

namespace selvage::spec {
namespace {

// Wider than high, and drawn on all over: the polygon reaches beyond the target on every side.
[[nodiscard]] Case whole_target() {
  Case c;
  c.target_width_px = 11;
  c.target_height_px = 5;
  c.filter = SELVAGE_FILTER_BILINEAR;
  c.vertices = {{-700, -300, 0, 0, 1}, {6000, -900, 900000, 0, 1}, {-900, 5000, 0, 700000, 1}};
  return c;
}

[[nodiscard]] std::vector<Case> audited_cases() {
  Case clipped = whole_target();
  clipped.has_clip = true;
  clipped.clip = {2, 1, 9, 5};
  Case high = whole_target();
  std::swap(high.target_width_px, high.target_height_px);
  high.flip_target = true;
  Case part = whole_target();
  part.vertices = {{300, 100, 0, 0, 7}, {2500, 400, 900000, 100, 3}, {900, 1200, 5, 700000, 5}};
  return {whole_target(), clipped, high, part};
}

using Check = Judgement (*)(const Subject&, const Case&);

// Verifiers that pass a law something else than the case they were asked about.
template <size_t kLaw, class Damage>
[[nodiscard]] Judgement damaged(const Subject& subject, const Case& c) {
  Case wrong = c;
  Damage()(wrong);
  return find_law(audited_laws()[kLaw])->check(subject, wrong);
}

struct NothingDrawn {
  void operator()(Case& c) const {
    for (selvage_vertex& v : c.vertices) v.x -= 100 * SELVAGE_SUBPIXELS;
    c.has_clip = true;
    c.clip = {};
  }
};
struct WithoutTheLastColumn {
  void operator()(Case& c) const { --c.target_width_px; }
};
struct WithoutTheLastRow {
  void operator()(Case& c) const { --c.target_height_px; }
};
struct SwappedSides {
  void operator()(Case& c) const { std::swap(c.target_width_px, c.target_height_px); }
};
struct WrongRectangle {
  void operator()(Case& c) const {
    c.has_clip = true;
    c.clip = {c.target_width_px / 2, 0, c.target_width_px, c.target_height_px};
  }
};
// Says the right number, but looks at a picture that the subject has not drawn.
template <size_t kLaw>
[[nodiscard]] Judgement boasting(const Subject&, const Case& c) {
  return find_law(audited_laws()[kLaw])->check(built_in(), c);
}
[[nodiscard]] Judgement empty_picture(const Subject&, const Case&) { return {}; }

struct WrongVerifier {
  std::string name;
  Check check;
};

template <size_t kLaw>
[[nodiscard]] std::vector<WrongVerifier> wrong_verifiers_of() {
  return {{"empty picture", empty_picture},
          {"nothing drawn", damaged<kLaw, NothingDrawn>},
          {"without the last column", damaged<kLaw, WithoutTheLastColumn>},
          {"without the last row", damaged<kLaw, WithoutTheLastRow>},
          {"width and height swapped", damaged<kLaw, SwappedSides>},
          {"wrong rectangle", damaged<kLaw, WrongRectangle>},
          {"another's picture", boasting<kLaw>}};
}

[[nodiscard]] std::string told(const Audit& a) {
  return std::to_string(a.judged_px) + " of " + std::to_string(a.due_px) + " px judged, " +
         std::to_string(a.missed.size()) + " wrong pixels not noticed" +
         (a.rejects_right ? ", the right mapper rejected" : "");
}

TEST(Audit, IsPassedByTheLaws) {
  for (const std::string_view name : audited_laws()) {
    for (const Case& c : audited_cases()) {
      ASSERT_TRUE(is_valid(c));
      const Audit result = audit(name, find_law(name)->check, c);
      EXPECT_TRUE(result.is_passed()) << name << ": " << told(result) << "\n" << print(c);
    }
  }
}

template <size_t kLaw>
void expect_that_wrong_ones_fail() {
  for (const WrongVerifier& wrong : wrong_verifiers_of<kLaw>()) {
    const Audit result = audit(audited_laws()[kLaw], wrong.check, whole_target());
    EXPECT_FALSE(result.is_passed())
        << audited_laws()[kLaw] << ", " << wrong.name << ": " << told(result);
  }
}

TEST(Audit, IsFailedByWrongVerifiers) {
  ASSERT_EQ(audited_laws().size(), 3U);
  expect_that_wrong_ones_fail<0>();
  expect_that_wrong_ones_fail<1>();
  expect_that_wrong_ones_fail<2>();
}

// The count alone does not tell a swapped picture, whose pixels are as many.
TEST(Audit, NeedsMoreThanTheCount) {
  const Audit swapped = audit("COV", damaged<0, SwappedSides>, whole_target());
  EXPECT_EQ(swapped.judged_px, swapped.due_px);
  EXPECT_FALSE(swapped.missed.empty());
}

}  // namespace
}  // namespace selvage::spec
