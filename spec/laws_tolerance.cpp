// Law TOLERANCE: what is drawn within a tolerance is within the bound that is told, and the bound
// within the tolerance.
#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "spec/canvas.h"
#include "spec/law_list.h"
#include "spec/law_tools.h"
#include "spec/tolerance.h"

namespace selvage::spec {
namespace {

constexpr std::string_view kLaw = "TOLERANCE";

// Any tolerance may be asked for; beyond a few texels nothing new is drawn by it.
inline constexpr int32_t kMostToleranceBits = 22;

// Kernels need not draw the same within a tolerance: a case is drawn by one of them, or by the
// fastest where the subject has no such one.
struct Tolerance {
  int32_t fx16;
  selvage_kernel kernel;
};

// Calls call(options), which draws nothing where it answers that there is no such kernel.
template <class Call>
[[nodiscard]] selvage_status by_some_kernel(selvage_options options, const Call& call) {
  const selvage_status status = call(options);
  if (status != SELVAGE_ERROR_KERNEL) return status;
  options.kernel = SELVAGE_KERNEL_FASTEST;
  return call(options);
}

[[nodiscard]] Subject tolerating(const Subject& subject, const Tolerance& tolerance) {
  Subject tolerant = subject;
  tolerant.draw = [draw = subject.draw, tolerance](
                      const selvage_image* target, const selvage_rect* clip,
                      const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                      const selvage_options* options) {
    selvage_options changed = *options;
    changed.tolerance = tolerance.fx16;
    changed.kernel = tolerance.kernel;
    return by_some_kernel(changed, [&](const selvage_options& by) {
      return draw(target, clip, vertices, count, texture, &by);
    });
  };
  return tolerant;
}

// Asks a subject what it would draw a case by.
class Asked {
 public:
  Asked(const Subject& subject, const Case& c, const Tolerance& tolerance)
      : subject_(subject),
        case_(c),
        options_{c.profile, c.filter, c.address, tolerance.fx16, tolerance.kernel},
        target_(c.format, c.target_width_px, c.target_height_px, c.padding_px, c.flip_target, 0),
        texture_(c.format, c.texture_width_texel, c.texture_height_texel, c.padding_px,
                 c.flip_texture, 0) {}

  [[nodiscard]] selvage_choice all() { return by_clip(case_.has_clip ? &case_.clip : nullptr); }
  [[nodiscard]] selvage_choice row(int32_t y_px) {
    selvage_rect clip = case_.has_clip ? case_.clip : selvage_rect{0, 0, case_.target_width_px, 0};
    const bool visible = !case_.has_clip || (clip.top <= y_px && y_px < clip.bottom);
    clip.top = y_px;
    clip.bottom = visible ? y_px + 1 : y_px;
    return by_clip(&clip);
  }

 private:
  [[nodiscard]] selvage_choice by_clip(const selvage_rect* clip) {
    const selvage_image image = target_.image();
    const selvage_texture texture = texture_.texture();
    selvage_choice choice{-1, -1, -1};  // stays, where an error is returned
    (void)by_some_kernel(options_, [&](const selvage_options& by) {
      return subject_.choose(&image, clip, case_.vertices.data(), case_.vertices.size(), &texture,
                             &by, &choice);
    });
    return choice;
  }

  const Subject& subject_;
  const Case& case_;
  selvage_options options_;
  Canvas target_, texture_;
};

[[nodiscard]] Rational to_texels(const Rational& fx16) { return fx16 / SELVAGE_SUBTEXELS; }

[[nodiscard]] bool is_stepped(const selvage_choice& choice) {
  return choice.method == SELVAGE_METHOD_SUBDIVIDED ||
         choice.method == SELVAGE_METHOD_AFFINE_FOR_PERSPECTIVE;
}

// What is wrong with a row's choice; empty if nothing.
[[nodiscard]] std::string fault_of(const selvage_choice& choice, const ScanLine& line,
                                   int32_t tolerance_fx16) {
  if (choice.method < SELVAGE_METHOD_NONE || choice.method > SELVAGE_METHOD_HISTORIC) {
    return "no method is told";
  }
  if (choice.bound < 0 || choice.bound > tolerance_fx16) return "the bound exceeds the tolerance";
  if ((choice.segment_px != 0) != (choice.method == SELVAGE_METHOD_SUBDIVIDED)) {
    return "segments without subdivision, or it without them";
  }
  if (!is_stepped(choice)) return choice.bound == 0 ? "" : "an exact method has a bound";
  if (choice.segment_px % 16 != 0) return "segments are no multiple of 16 px";
  return to_texels(choice.bound) >= chord_bound(line, choice.segment_px)
             ? ""
             : "the bound is less than the derived one";
}

// What is told of some rows, and of one more.
[[nodiscard]] selvage_choice together(const selvage_choice& some, const selvage_choice& row) {
  const bool shorter = row.segment_px != 0 && row.segment_px < some.segment_px;
  return {std::max(some.method, row.method),
          some.segment_px == 0 || shorter ? row.segment_px : some.segment_px,
          std::max(some.bound, row.bound)};
}

[[nodiscard]] bool same(const selvage_choice& a, const selvage_choice& b) {
  return a.method == b.method && a.segment_px == b.segment_px && a.bound == b.bound;
}

[[nodiscard]] std::string text_of(const selvage_choice& choice) {
  return "method " + std::to_string(choice.method) + ", segments of " +
         std::to_string(choice.segment_px) + " px, bound " + std::to_string(choice.bound) +
         "/65536 texel";
}

// The rows of a case as they are drawn within a tolerance.
class TolerantCase {
 public:
  TolerantCase(const Subject& subject, const Case& c, const Tolerance& tolerance)
      : subject_(subject),
        case_(c),
        tolerance_fx16_(tolerance.fx16),
        drawn_(draw(tolerating(subject, tolerance), c)),
        asked_(subject, c, tolerance) {
    for (int32_t y = 0; y < c.target_height_px; ++y) {
      lines_.push_back(scan_line(c.vertices, y));
      columns_.push_back(lines_.back() ? columns_of(*lines_.back()) : Columns{0, 0});
    }
  }

  [[nodiscard]] Judgement judge() {
    const bool asks_rows = subject_.choose && subject_.claims.clip;
    Judgement judgement = judge_coverage();
    selvage_choice all{SELVAGE_METHOD_NONE, 0, 0};
    for (int32_t y = 0; !judgement.violation && y < case_.target_height_px; ++y) {
      const std::optional<ScanLine>& line = lines_[static_cast<size_t>(y)];
      if (columns_[static_cast<size_t>(y)].empty()) continue;
      Rational allowed = to_texels(tolerance_fx16_);
      if (asks_rows) {
        const selvage_choice choice = asked_.row(y);
        const std::string fault = fault_of(choice, *line, tolerance_fx16_);
        if (!fault.empty()) return blame(std::move(judgement), fault, choice, y);
        all = together(all, choice);
        allowed = is_stepped(choice) ? std::min(to_texels(choice.bound),
                                                Rational(chord_bound(*line, choice.segment_px) +
                                                         to_texels(rounding_bound_fx16(*line))))
                                     : Rational(0);
      }
      allowed += accuracy_of(subject_);
      add(&judgement, judge_row(y, *line, allowed));
    }
    if (judgement.violation || !asks_rows || same(asked_.all(), all)) return judgement;
    return blame(std::move(judgement),
                 "of all rows the last method, the shortest segments, the greatest bound are told",
                 asked_.all(), -1);
  }

 private:
  [[nodiscard]] bool is_due(int32_t x, int32_t y) const {
    const bool clipped = case_.has_clip && (x < case_.clip.left || case_.clip.right <= x ||
                                            y < case_.clip.top || case_.clip.bottom <= y);
    const Columns& columns = columns_[static_cast<size_t>(y)];
    return !clipped && columns.first_px <= x && x < columns.end_px;
  }

  // Which pixels are drawn is exact whatever the tolerance.
  [[nodiscard]] Judgement judge_coverage() const {
    return compare(kLaw, "which pixels are drawn does not depend on the tolerance", case_, drawn_,
                   [&](int32_t x, int32_t y) {
                     const bool due = is_due(x, y);
                     if (due == drawn_.at(x, y).has_value()) return must_be(drawn_.at(x, y));
                     return must_be(due ? expected(case_).at(x, y) : MaybePixel());
                   });
  }

  [[nodiscard]] Judgement judge_row(int32_t y, const ScanLine& line,
                                    const Rational& allowed) const {
    const TexelLaw law{kLaw,
                       "within " + to_texels(tolerance_fx16_).get_str() +
                           " texel, a texel lies within " + allowed.get_str() +
                           " texel of its exact (u, v)",
                       case_};
    Judgement judgement;
    for (int32_t x = 0; x < case_.target_width_px; ++x) {
      const std::optional<uint32_t>& pixel = drawn_.at(x, y);
      const std::optional<Sample> exact = pixel ? sample(line, x) : std::nullopt;
      if (exact && !law.judge({x, y}, reach_around(*exact, allowed), *pixel, &judgement)) break;
    }
    return judgement;
  }

  [[nodiscard]] Judgement blame(Judgement judgement, const std::string& fault,
                                const selvage_choice& choice, int32_t y_px) const {
    judgement.violation = violation_of_call(
        kLaw,
        "row " + std::to_string(y_px) + ", within " + to_texels(tolerance_fx16_).get_str() +
            " texel: " + fault,
        case_, "a choice whose bound is derived and within the tolerance", text_of(choice));
    return judgement;
  }

  const Subject& subject_;
  const Case& case_;
  int32_t tolerance_fx16_;
  Picture drawn_;
  Asked asked_;
  std::vector<std::optional<ScanLine>> lines_;  // of the rows
  std::vector<Columns> columns_;                // that they cover
};

// Linearly from [least, greatest] of the values to [to_least, to_greatest].
void fit(std::vector<selvage_vertex>* vertices, int32_t selvage_vertex::*axis, int64_t to_least,
         int64_t to_greatest) {
  const auto [low, high] = std::ranges::minmax(*vertices, {}, axis);
  const int64_t from = low.*axis, extent = std::max(int64_t{high.*axis} - from, int64_t{1});
  for (selvage_vertex& v : *vertices) {
    v.*axis = static_cast<int32_t>(to_least + (v.*axis - from) * (to_greatest - to_least) / extent);
  }
}

// The case on wide rows and with milder depths: where tolerance has something to say.
[[nodiscard]] Case made_wide(const Case& c, Choices& choices) {
  Case wide = c;
  wide.has_clip = choices.pick(0, 4) == 0;
  wide.clip = {choices.pick(0, 60), 0, choices.pick(60, 400), 100};
  wide.target_width_px = choices.pick(160, 400);
  wide.target_height_px = choices.pick(1, 6);
  const int32_t beyond = choices.pick(0, 2) * choices.pick(0, 1 << 16);
  fit(&wide.vertices, &selvage_vertex::x, -beyond,
      int64_t{wide.target_width_px} * SELVAGE_SUBPIXELS + beyond);
  fit(&wide.vertices, &selvage_vertex::y, -choices.pick(0, 512),
      int64_t{wide.target_height_px} * SELVAGE_SUBPIXELS + choices.pick(0, 512));
  const int32_t base = 1 << choices.pick(4, 24);
  const int32_t spread = std::max(base >> choices.pick(0, 10), 1);
  const int halvings = choices.pick(0, 16);
  for (selvage_vertex& v : wide.vertices) {
    v.q = base - v.q % spread;
    v.u >>= halvings;
    v.v >>= halvings;
  }
  return wide;
}

// Powers of two in between, and what some row's own bound is, or just not.
[[nodiscard]] int32_t some_tolerance(const Case& c, Choices& choices) {
  constexpr std::array kUsual = {SELVAGE_SUBTEXELS / 256, SELVAGE_SUBTEXELS / 16,
                                 SELVAGE_SUBTEXELS / 4, int32_t{SELVAGE_SUBTEXELS}};
  const int32_t kind = choices.pick(0, 3);
  if (kind == 0) return kUsual[static_cast<size_t>(choices.pick(0, 4))];
  const int32_t any = (1 << choices.pick(0, kMostToleranceBits)) + choices.pick(0, 16);
  const auto line = scan_line(c.vertices, choices.pick(0, c.target_height_px));
  if (kind == 1 || !line || columns_of(*line).empty()) return any;
  const int32_t segment_px = 16 * choices.pick(0, 20);
  const Rational bound =
      chord_bound(*line, segment_px) * SELVAGE_SUBTEXELS + rounding_bound_fx16(*line);
  return bound < (1 << kMostToleranceBits) ? std::max(floor(bound) + choices.pick(-2, 3), 1) : any;
}

[[nodiscard]] selvage_kernel some_kernel(const Case& c) {
  constexpr uint32_t kOwnChoices = 0x9E3779B9;  // apart from those that make the case
  Choices choices(c.choice ^ kOwnChoices);
  return static_cast<selvage_kernel>(choices.pick(SELVAGE_KERNEL_FASTEST, SELVAGE_KERNEL_NEON + 1));
}

}  // namespace

Judgement check_tolerance(const Subject& subject, const Case& any) {
  const Case c = with_nearest(any);
  Judgement judgement;
  if (!is_valid(c) || c.profile != SELVAGE_PROFILE_EXACT) return judgement;
  Choices choices(c.choice);
  for (const Case& shown : {c, within(subject.claims, made_wide(c, choices))}) {
    if (!is_valid(shown)) continue;
    const Tolerance tolerance{some_tolerance(shown, choices), some_kernel(shown)};
    if (add(&judgement, TolerantCase(subject, shown, tolerance).judge())) break;
  }
  return judgement;
}

}  // namespace selvage::spec
