// Laws of robustness: MEM, TOTAL.
#include <string>

#include "spec/hostile_calls.h"
#include "spec/hostile_lists.h"
#include "spec/law_list.h"
#include "spec/law_tools.h"
#include "spec/status_name.h"

namespace selvage::spec {

Judgement check_mem(const Subject& subject, const Case& c) {
  const Picture picture = draw(subject, c);
  Judgement judgement = {.judged_px = picture.pixels.size()};
  if (!picture.memory_fault.empty()) {
    judgement.violation = violation_of_call(
        "MEM",
        "nothing but pixels of the target is written, and they do not depend on what was there", c,
        "an untouched surrounding", picture.memory_fault);
    return judgement;
  }
  const auto wanted = [&](int32_t x, int32_t y) {
    return is_visible(c, {x, y}) ? unjudged() : must_be(std::nullopt);
  };
  add(&judgement,
      compare("MEM", "nothing outside the clip rectangle is written", c, picture, wanted));
  return judgement;
}

namespace {

[[nodiscard]] Judgement judge_status(const Subject& subject, const Case& c) {
  const Picture picture = draw(subject, c);
  const selvage_status wanted = validity(c);
  Judgement judgement = {.judged_px = 1};
  if (picture.status != wanted) {
    judgement.violation =
        violation_of_call("TOTAL", "an outline is drawn or refused as the specification says", c,
                          "status " + status_name(wanted), "status " + status_name(picture.status));
    return judgement;
  }
  if (wanted == SELVAGE_OK) return judgement;
  add(&judgement, compare("TOTAL", "an error draws nothing", c, picture,
                          [](int32_t, int32_t) { return must_be(std::nullopt); }));
  return judgement;
}

}  // namespace

namespace {

[[nodiscard]] std::string told_of(const std::optional<size_t>& failed) {
  return failed ? "polygon " + std::to_string(*failed) + " to blame" : "no polygon to blame";
}

[[nodiscard]] Violation wrong_status(const std::string& what, const Case& good,
                                     selvage_status wanted, selvage_status answer) {
  return violation_of_call("TOTAL", "each call gets the status it should: " + what, good,
                           "status " + status_name(wanted), "status " + status_name(answer));
}

[[nodiscard]] Violation drawn_all_the_same(const std::string& what, const Case& good) {
  return violation_of_call("TOTAL", "an error draws nothing: " + what, good, "an untouched target",
                           "a written target");
}

// One polygon a call.
[[nodiscard]] Judgement judge_calls(const Subject& subject, const Case& c, const Case& good) {
  Judgement judgement;
  for (const HostileCall& hostile : hostile_calls(c, subject)) {
    ++judgement.judged_px;
    const HostileOutcome outcome = make(subject, good, hostile);
    if (outcome.status != hostile.wanted) {
      judgement.violation = wrong_status(hostile.what, good, hostile.wanted, outcome.status);
      break;
    }
    if (hostile.wanted != SELVAGE_OK && !outcome.target_untouched) {
      judgement.violation = drawn_all_the_same(hostile.what, good);
      break;
    }
  }
  return judgement;
}

// Several polygons a call, all or nothing.
[[nodiscard]] Judgement judge_lists(const Subject& subject, const Case& c, const Case& good) {
  Judgement judgement;
  for (const HostileList& hostile : hostile_lists(c)) {
    ++judgement.judged_px;
    const ListOutcome outcome = make(subject, good, hostile);
    if (outcome.status != hostile.wanted) {
      judgement.violation = wrong_status(hostile.what, good, hostile.wanted, outcome.status);
      break;
    }
    if (!hostile.draws && !outcome.target_untouched) {
      judgement.violation = drawn_all_the_same(hostile.what, good);
      break;
    }
    if (outcome.failed == hostile.failed) continue;
    judgement.violation = violation_of_call(
        "TOTAL", "a call for many tells the polygon that is refused, and no other: " + hostile.what,
        good, told_of(hostile.failed), told_of(outcome.failed));
    break;
  }
  return judgement;
}

}  // namespace

Judgement check_total(const Subject& subject, const Case& c) {
  Judgement judgement = judge_status(subject, c);
  if (judgement.violation) return judgement;
  const Case good = good_drawing(subject, c);
  if (add(&judgement, judge_calls(subject, c, good)) || !subject.draw_many) return judgement;
  add(&judgement, judge_lists(subject, c, good));
  return judgement;
}

}  // namespace selvage::spec
