#include "spec/audit.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "spec/geometry.h"
#include "spec/model.h"
#include "spec/picture.h"
#include "spec/spoiled_subject.h"

namespace selvage::spec {
namespace {

using Kind = Moment::Kind;

// Which pixels of a drawing the law looks at.
enum class Region {
  kTarget,
  kCovered,
  kWideRow  // the first 96 columns of the first row: TOLERANCE's second drawing has them
};
inline constexpr int32_t kWideRow_px = 96;

struct Due {
  Region region;
  std::vector<Moment> moments;
  std::vector<Spoiling> spoilings;
};

[[nodiscard]] std::vector<Moment> drawings(std::initializer_list<int32_t> numbers) {
  std::vector<Moment> moments;
  for (const int32_t number : numbers) moments.push_back({Kind::kDrawing, number});
  return moments;
}

[[nodiscard]] std::vector<Due> wherever(std::initializer_list<int32_t> numbers) {
  return {{Region::kTarget, drawings(numbers), {Spoiling::kToggled, Spoiling::kOtherBits}}};
}

[[nodiscard]] std::vector<Due> coverage(std::initializer_list<int32_t> numbers) {
  return {{Region::kTarget, drawings(numbers), {Spoiling::kToggled}}};
}

[[nodiscard]] std::vector<Due> covered_texels(std::initializer_list<int32_t> numbers) {
  return {{Region::kCovered, drawings(numbers), {Spoiling::kOtherBits}}};
}

[[nodiscard]] std::vector<Due> due_of_tolerance() {
  std::vector<Due> due = wherever({0});
  due.push_back({Region::kWideRow, drawings({1}), {Spoiling::kToggled}});
  return due;
}

// SAME draws a texture as given, padded and in tiles, if its texels are to be exact, and then
// polygons over each other: through clips, by kernels, by threads.
[[nodiscard]] std::vector<Due> due_of_same(bool exact) {
  std::vector<Moment> moments = {{Kind::kTile, 0}, {Kind::kKernel, SELVAGE_KERNEL_SCALAR}};
  for (const int32_t threads : {1, 2, 3, 8}) moments.push_back({Kind::kThreads, threads});
  std::vector<Due> due = exact ? wherever({0, 1, 2}) : std::vector<Due>();
  due.push_back({Region::kTarget, std::move(moments), {Spoiling::kPainted}});
  return due;
}

// Drawings are numbered as the law makes them: CLIP draws whole, then clipped; SHIFT the target
// shifted, then the texture; MIRROR flips the texture, then the target twice, then turns it, each
// time from one drawing to another; SPLIT draws the whole and its parts. Two drawings by a mapper
// whose texels are not exact need not show the same ones.
[[nodiscard]] std::vector<Due> due_of(std::string_view law, bool exact) {
  const auto compared = exact ? wherever : coverage;
  if (law == "COV" || law == "TOTAL") return coverage({0});
  if (law == "PART") return coverage({0, 1, 2});
  if (law == "CLIP") return compared({1});
  if (law == "SHIFT") return compared({2, 3});
  if (law == "ORDER") return compared({0, 1, 2});
  if (law == "MIRROR") return compared({2, 4, 6});
  if (law == "SPLIT") return compared({0, 1, 2});
  if (law == "IDENTITY") return wherever({0});
  if (law == "AFFINE") return compared({0, 1});
  if (law == "FILTER") return covered_texels({0, 1});
  if (law == "TOLERANCE") return due_of_tolerance();
  if (law == "MEM") return {{Region::kTarget, drawings({0}), {Spoiling::kDependent}}};
  if (law == "SAME") return due_of_same(exact);
  return covered_texels({0});  // MAP, DDA, GAMUT, ORACLE
}

// How many pixels of the target and how many covered ones a law judges, others besides, and how
// often it draws the case's own outline, as it is or moved within the target.
struct Count {
  std::string_view law;
  uint64_t targets, covered;
  bool exactly;
  uint64_t others;
  uint64_t drawings;
};
constexpr std::array kCounts = {
    Count{"COV", 1, 0, true, 0, 1},      Count{"PART", 1, 0, true, 0, 0},
    Count{"PINWHEEL", 0, 0, true, 1, 0}, Count{"CLIP", 4, 0, true, 0, 2},
    Count{"VERT", 0, 0, false, 1, 0},    Count{"MAP", 0, 1, true, 0, 1},
    Count{"DDA", 0, 1, true, 0, 1},      Count{"GAMUT", 0, 1, true, 0, 1},
    Count{"SHIFT", 1, 0, false, 0, 3},   Count{"ORDER", 2, 0, true, 0, 2},
    Count{"MIRROR", 3, 0, false, 0, 6},  Count{"SPLIT", 1, 0, false, 0, 0},
    Count{"IDENTITY", 1, 0, true, 0, 0}, Count{"AFFINE", 1, 0, false, 0, 2},
    Count{"FILTER", 0, 2, true, 0, 2},   Count{"TOLERANCE", 1, 1, false, kWideRow_px, 1},
    Count{"MEM", 1, 0, false, 0, 1},     Count{"TOTAL", 1, 0, false, 1, 0},
    Count{"SAME", 8, 0, false, 0, 3},    Count{"ORACLE", 0, 1, true, 0, 1},
};
inline constexpr uint64_t kCallsPerDrawing = 2;

// Without exact texels SAME compares no layouts: it judges one drawing more.
[[nodiscard]] Count without_texels(Count count) {
  if (count.law != "SAME") return count;
  count.targets -= 1;
  count.drawings = 0;
  return count;
}

// What an audit asks: a check, and by mappers of which claims.
struct Question {
  const Check& check;
  Accuracy accuracy;

  [[nodiscard]] Judgement of(Subject subject, const Case& c) const {
    subject.claims.accuracy_fx16 = accuracy.texels_fx16;
    subject.claims.coverage_accuracy_fx16 = accuracy.coverage_fx16;
    return check(subject, c);
  }
  [[nodiscard]] bool shows_exact() const { return accuracy.texels_fx16 == 0; }
};

[[nodiscard]] std::vector<Pixel> pixels_within(int32_t width_px, int32_t height_px) {
  std::vector<Pixel> pixels;
  for (int32_t y = 0; y < height_px; ++y) {
    for (int32_t x = 0; x < width_px; ++x) pixels.push_back({x, y});
  }
  return pixels;
}

// From the model: a refused outline covers nothing.
[[nodiscard]] std::vector<Pixel> pixels_of(const Case& c, Region region) {
  if (region == Region::kWideRow) return pixels_within(kWideRow_px, 1);
  std::vector<Pixel> pixels = pixels_within(c.target_width_px, c.target_height_px);
  if (region == Region::kTarget) return pixels;
  Case nearest = c;
  nearest.filter = SELVAGE_FILTER_NEAREST;
  const Picture model = expected(nearest);
  std::erase_if(pixels, [&](Pixel p) { return !model.at(p.x_px, p.y_px); });
  return pixels;
}

[[nodiscard]] bool notices(const Question& question, const Case& c, const Spot& spot) {
  return question.of(wrong_in(spot, c.profile), c).violation.has_value();
}

[[nodiscard]] std::string text_of(const Spot& spot) {
  return "pixel (" + std::to_string(spot.x_px) + ", " + std::to_string(spot.y_px) +
         "), spoiled in way " + std::to_string(static_cast<int>(spot.how)) + " at moment " +
         std::to_string(static_cast<int>(spot.when.kind)) + "." + std::to_string(spot.when.number);
}

[[nodiscard]] std::optional<std::string> first_missed(std::string_view law,
                                                      const Question& question, const Case& c) {
  for (const Due& due : due_of(law, question.shows_exact())) {
    for (const Pixel p : pixels_of(c, due.region)) {
      for (const Moment when : due.moments) {
        for (const Spoiling how : due.spoilings) {
          const Spot spot{when, how, p.x_px, p.y_px};
          if (!notices(question, c, spot)) return text_of(spot);
        }
      }
    }
  }
  return std::nullopt;
}

void judge_right(const Question& question, const Case& c, const Count& count, Audit* result) {
  const auto drawn_px = std::make_shared<uint64_t>(0);
  const Judgement of_right = question.of(counting(drawn_px, c.profile), c);
  result->due_px = count.targets * pixels_of(c, Region::kTarget).size() +
                   count.covered * pixels_of(c, Region::kCovered).size() + count.others;
  result->due_exactly = count.exactly;
  result->due_drawn_px = std::max<uint64_t>(
      1, kCallsPerDrawing * count.drawings * pixels_of(c, Region::kCovered).size());
  result->judged_px = of_right.judged_px;
  result->drawn_px = *drawn_px;
  result->rejects_right = of_right.violation.has_value();
}

// Of a law that looks at a few pixels, another few with each choice: after so many choices a pixel
// of the target has been left out with a chance of e^-12.
inline constexpr uint32_t kChoicesPerPixel = 12;

[[nodiscard]] Audit audit_by_choices(const Question& question, Case c, const Count& count) {
  std::vector<Pixel> unseen = pixels_of(c, Region::kTarget);
  const auto choices = static_cast<uint32_t>(unseen.size()) * kChoicesPerPixel;
  Audit result;
  for (c.choice = 0; c.choice < choices && !unseen.empty(); ++c.choice) {
    judge_right(question, c, count, &result);
    if (!result.is_passed()) return result;
    std::erase_if(unseen, [&](Pixel p) {
      return notices(question, c, {{}, Spoiling::kToggled, p.x_px, p.y_px}) ||
             notices(question, c, {{}, Spoiling::kOtherBits, p.x_px, p.y_px});
    });
  }
  if (!unseen.empty()) {
    result.missed = text_of({{}, Spoiling::kToggled, unseen[0].x_px, unseen[0].y_px});
  }
  return result;
}

}  // namespace

Audit audit(std::string_view law, const Check& check, const Case& c, const Accuracy& accuracy) {
  const auto known = std::ranges::find(kCounts, law, &Count::law);
  if (known == kCounts.end()) return {};  // nothing is due, and that is no pass
  const Question question{check, accuracy};
  const Count count = question.shows_exact() ? *known : without_texels(*known);
  if (law == "PINWHEEL" || law == "VERT") return audit_by_choices(question, c, count);
  Audit result;
  judge_right(question, c, count, &result);
  if (result.is_passed()) result.missed = first_missed(law, question, c);
  return result;
}

}  // namespace selvage::spec
