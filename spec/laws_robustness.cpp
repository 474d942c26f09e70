// Laws of robustness: MEM, TOTAL.
#include "spec/hostile_calls.h"
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
    const bool clipped = c.has_clip && (x < c.clip.left || c.clip.right <= x || y < c.clip.top ||
                                        c.clip.bottom <= y);
    return clipped ? must_be(std::nullopt) : unjudged();
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

Judgement check_total(const Subject& subject, const Case& c) {
  Judgement judgement = judge_status(subject, c);
  if (judgement.violation) return judgement;
  for (const HostileCall& hostile : hostile_calls(c, subject)) {
    ++judgement.judged_px;
    const HostileOutcome outcome = make(subject, c, hostile);
    if (outcome.status != hostile.wanted) {
      judgement.violation = violation_of_call(
          "TOTAL", "each call gets the status it should: " + hostile.what, c,
          "status " + status_name(hostile.wanted), "status " + status_name(outcome.status));
      return judgement;
    }
    if (hostile.wanted != SELVAGE_OK && !outcome.target_untouched) {
      judgement.violation = violation_of_call("TOTAL", "an error draws nothing: " + hostile.what, c,
                                              "an untouched target", "a written target");
      return judgement;
    }
  }
  return judgement;
}

}  // namespace selvage::spec
