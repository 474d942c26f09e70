// The laws are verifiers, and verifiers can be wrong: one that looks at nothing, or in the wrong
// place, passes every mapper. The audit must tell such ones from the laws.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "spec/audit.h"
#include "spec/model.h"

namespace selvage::spec {
namespace {

// Wider than high, some of it drawn; no centre is a tie.
[[nodiscard]] Case part_of_target() {
  Case c;
  c.target_width_px = 9;
  c.target_height_px = 5;
  c.vertices = {{300, 100, 0, 0, 7}, {2200, 400, 900000, 100, 3}, {900, 1200, 5, 700000, 5}};
  return c;
}

// The polygon reaches beyond the target on every side.
[[nodiscard]] Case whole_target() {
  Case c = part_of_target();
  c.vertices = {{-700, -300, 0, 0, 7}, {6000, -900, 900000, 0, 3}, {-900, 5000, 0, 700000, 5}};
  return c;
}

[[nodiscard]] Case clipped(Case c) {
  c.has_clip = true;
  c.clip = {2, 1, 8, 5};
  return c;
}

[[nodiscard]] Case high(Case c) {
  std::swap(c.target_width_px, c.target_height_px);
  c.flip_target = true;
  return c;
}

[[nodiscard]] Case filtered(Case c) {
  c.filter = SELVAGE_FILTER_BILINEAR;
  return c;
}

[[nodiscard]] Case with_outline(std::vector<selvage_vertex> vertices) {
  Case c = part_of_target();
  c.vertices = std::move(vertices);
  return c;
}

[[nodiscard]] Case small(Case c) {
  c.target_width_px = 5;
  c.target_height_px = 3;
  return c;
}

// What a law is audited by: see spec/audit.h. Of the first, pixels in all rows and columns matter.
[[nodiscard]] std::vector<Case> cases_for(std::string_view law) {
  const Case part = part_of_target(), whole = whole_target();
  if (law == "CLIP" || law == "MEM") return {clipped(part), clipped(filtered(whole))};
  if (law == "SPLIT") {
    return {with_outline(
        {{300, 100, 0, 0, 1}, {2200, 300, 0, 0, 1}, {1900, 1200, 0, 0, 1}, {400, 900, 0, 0, 1}})};
  }
  if (law == "TOTAL") {  // not y-monotone
    return {with_outline({{300, 100, 0, 0, 1},
                          {800, 1000, 0, 0, 1},
                          {1300, 200, 0, 0, 1},
                          {1800, 1000, 0, 0, 1},
                          {2200, 100, 0, 0, 1},
                          {1300, 1250, 0, 0, 1}})};
  }
  if (law == "DDA") {
    return {in_profile(whole, SELVAGE_PROFILE_ABRASH56), in_profile(part, SELVAGE_PROFILE_ABRASH57),
            in_profile(part, SELVAGE_PROFILE_DKIT)};
  }
  if (law == "FILTER") return {filtered(whole), filtered(part), high(filtered(part))};
  if (law == "COV" || law == "MAP") return {whole, part, high(part), clipped(whole)};
  if (law == "GAMUT" || law == "ORACLE") return {whole, high(part)};
  if (law == "PINWHEEL" || law == "VERT") return {small(part)};
  if (law == "IDENTITY") return {part};  // its choice is of a rectangle that is seen
  return {part, high(part)};
}

// The rows of a target, to be put back. Empty where the call is refused.
class Snapshot {
 public:
  explicit Snapshot(const selvage_image& image) : image_(image) {
    for (int32_t y = 0; y < image.height; ++y) {
      rows_.emplace_back(row(y), row(y) + image.width * bytes_px());
    }
  }
  // Pixels [left, right) x [top, bottom) of the image become what they were here.
  void restore(const selvage_rect& window) const {
    const int32_t left = std::clamp(window.left, 0, image_.width);
    const int32_t right = std::clamp(window.right, left, image_.width);
    for (int32_t y = std::max(window.top, 0); y < std::min(window.bottom, image_.height); ++y) {
      std::memcpy(row(y) + left * bytes_px(),
                  rows_[static_cast<size_t>(y)].data() + left * bytes_px(),
                  static_cast<size_t>((right - left) * bytes_px()));
    }
  }
  void restore() const { restore({0, 0, image_.width, image_.height}); }

 private:
  [[nodiscard]] ptrdiff_t bytes_px() const {
    return image_.format == SELVAGE_INDEX8 ? 1 : image_.format == SELVAGE_RGB565 ? 2 : 4;
  }
  [[nodiscard]] char* row(int32_t y) const {
    return static_cast<char*>(image_.pixels) + y * image_.pitch;
  }

  selvage_image image_;
  std::vector<std::vector<char>> rows_;
};

// `theirs` draws within the window, `right` beside it.
template <class Theirs, class Right>
[[nodiscard]] selvage_status draw_in_window(const selvage_image& target, const selvage_rect& window,
                                            Theirs theirs, Right right) {
  const Snapshot before(target);
  const selvage_status status = theirs();
  const Snapshot after(target);
  before.restore();
  (void)right();
  after.restore(window);
  return status;
}

// What a verifier sees of a subject that looks through a window only.
[[nodiscard]] Subject seen_through(const Subject& subject, selvage_rect window) {
  Subject seen = subject;
  const Subject right = built_in(subject.profile);
  seen.draw = [=](const selvage_image* target, const selvage_rect* clip,
                  const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                  const selvage_options* options) {
    const selvage_rect nothing{0, 0, 0, 0};
    const bool refused =
        right.draw(target, &nothing, vertices, 0, texture, options) != SELVAGE_ERROR_VERTEX_COUNT;
    const auto by = [&](const Subject& mapper) {
      return mapper.draw(target, clip, vertices, count, texture, options);
    };
    if (refused) return by(subject);
    return draw_in_window(
        *target, window, [&] { return by(subject); }, [&] { return by(right); });
  };
  seen.draw_many = [=](const selvage_image* target, const selvage_rect* clip,
                       const selvage_polygon* polygons, size_t count,
                       const selvage_options* options, int32_t threads, size_t* failed) {
    const auto by = [&](const Subject& mapper) {
      return mapper.draw_many(target, clip, polygons, count, options, threads, failed);
    };
    if (target == nullptr) return by(subject);
    return draw_in_window(
        *target, window, [&] { return by(subject); }, [&] { return by(right); });
  };
  return seen;
}

// The picture stays empty, whoever draws it.
[[nodiscard]] Subject unseen(const Subject& subject) {
  Subject seen = subject;
  seen.draw = [draw = subject.draw](
                  const selvage_image* target, const selvage_rect*, const selvage_vertex* vertices,
                  size_t count, const selvage_texture* texture, const selvage_options* options) {
    const selvage_rect nothing{0, 0, 0, 0};
    return draw(target, &nothing, vertices, count, texture, options);
  };
  seen.draw_many = [many = subject.draw_many](const selvage_image* target, const selvage_rect*,
                                              const selvage_polygon* polygons, size_t count,
                                              const selvage_options* options, int32_t threads,
                                              size_t* failed) {
    const selvage_rect nothing{0, 0, 0, 0};
    return many(target, &nothing, polygons, count, options, threads, failed);
  };
  return seen;
}

struct WrongVerifier {
  std::string name;
  Check check;
};

[[nodiscard]] WrongVerifier through_window(std::string name, const Law& law, selvage_rect window) {
  return {std::move(name), [&law, window](const Subject& subject, const Case& c) {
            return law.check(seen_through(subject, window), c);
          }};
}

// Wrong in what they look at, whatever law they claim to check.
[[nodiscard]] std::vector<WrongVerifier> wrong_verifiers_of(const Law& law, const Case& of) {
  const int32_t w = of.target_width_px, h = of.target_height_px;
  return {
      {"looks at nothing", [](const Subject&, const Case&) { return Judgement{}; }},
      {"empty picture",
       [&law](const Subject& subject, const Case& c) { return law.check(unseen(subject), c); }},
      // Says the right number, but of a picture that the subject has not drawn.
      {"another's picture",
       [&law](const Subject& subject, const Case& c) {
         return law.check(built_in(subject.profile), c);
       }},
      through_window("without the last column", law, {0, 0, w - 1, h}),
      through_window("without the last row", law, {0, 0, w, h - 1}),
      through_window("width and height swapped", law, {0, 0, h, w}),
      through_window("wrong rectangle", law, {w / 2, 0, w, h}),
  };
}

[[nodiscard]] std::string told(const Audit& a) {
  return std::to_string(a.judged_px) + " px judged, due " + (a.due_exactly ? "" : "at least ") +
         std::to_string(a.due_px) + ", drawn " + std::to_string(a.drawn_px) + ", due at least " +
         std::to_string(a.due_drawn_px) + (a.rejects_right ? ", the right mapper rejected" : "") +
         (a.missed ? ", not noticed: " + *a.missed : "");
}

class Audits : public testing::TestWithParam<Law> {};

TEST_P(Audits, IsPassedByTheLaw) {
  const Law& law = GetParam();
  for (const Case& c : cases_for(law.name)) {
    ASSERT_EQ(is_valid(c), law.name != "TOTAL") << print(c);
    const Audit result = audit(law.name, law.check, c);
    EXPECT_TRUE(result.is_passed()) << told(result) << "\n" << print(c);
  }
}

TEST_P(Audits, IsPassedByTheLawWithinAnAccuracy) {
  const Law& law = GetParam();
  for (const Case& c : cases_for(law.name)) {
    if (c.profile != SELVAGE_PROFILE_EXACT) continue;
    for (const Accuracy& accuracy : {Accuracy{.texels_fx16 = 1}, Accuracy{.coverage_fx16 = 1}}) {
      const Audit result = audit(law.name, law.check, c, accuracy);
      EXPECT_TRUE(result.is_passed()) << accuracy.coverage_fx16 << ": " << told(result) << "\n"
                                      << print(c);
    }
  }
}

TEST_P(Audits, IsFailedByWrongVerifiers) {
  const Law& law = GetParam();
  const Case c = cases_for(law.name).front();
  for (const WrongVerifier& wrong : wrong_verifiers_of(law, c)) {
    const Audit result = audit(law.name, wrong.check, c);
    EXPECT_FALSE(result.is_passed()) << wrong.name << ": " << told(result) << "\n" << print(c);
    // Not for being too strict: these would pass every right mapper.
    EXPECT_TRUE(!result.rejects_right || wrong.name == "empty picture") << wrong.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, Audits, testing::ValuesIn(laws().begin(), laws().end()),
                         [](const auto& of) { return std::string(of.param.name); });

// Verifiers that pass a law another case than the one they were asked about.
template <class Damage>
[[nodiscard]] Check damaged(std::string_view law, Damage damage) {
  return [law, damage](const Subject& subject, const Case& c) {
    Case wrong = c;
    damage(wrong);
    return find_law(law)->check(subject, wrong);
  };
}

void swap_sides(Case& c) { std::swap(c.target_width_px, c.target_height_px); }

TEST(Audit, IsFailedByLawsOfAnotherCase) {
  for (const std::string_view law : {"COV", "MAP", "FILTER"}) {
    const WrongVerifier all[] = {
        {"nothing drawn", damaged(law,
                                  [](Case& c) {
                                    c.has_clip = true;
                                    c.clip = {};
                                  })},
        {"without the last column", damaged(law, [](Case& c) { --c.target_width_px; })},
        {"without the last row", damaged(law, [](Case& c) { --c.target_height_px; })},
        {"width and height swapped", damaged(law, swap_sides)},
        {"wrong rectangle", damaged(law, [](Case& c) {
           c.has_clip = true;
           c.clip = {c.target_width_px / 2, 0, c.target_width_px, c.target_height_px};
         })}};
    for (const WrongVerifier& wrong : all) {
      const Audit result = audit(law, wrong.check, filtered(whole_target()));
      EXPECT_FALSE(result.is_passed()) << law << ", " << wrong.name << ": " << told(result);
    }
  }
}

// The count alone does not tell a swapped picture, whose pixels are as many.
TEST(Audit, NeedsMoreThanTheCount) {
  const Audit swapped = audit("COV", damaged("COV", swap_sides), whole_target());
  EXPECT_EQ(swapped.judged_px, swapped.due_px);
  EXPECT_TRUE(swapped.missed);
}

// A law that nobody has said how to audit has not passed.
TEST(Audit, IsFailedByALawItDoesNotKnow) {
  const Audit unknown = audit("BEAUTY", find_law("COV")->check, whole_target());
  EXPECT_FALSE(unknown.is_passed());
}

}  // namespace
}  // namespace selvage::spec
