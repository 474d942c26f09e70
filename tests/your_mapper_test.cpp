// How to hold a mapper of your own against the laws: wrap its draw call, and ask.
#include <gtest/gtest.h>

#include <iostream>

#include "spec/verify.h"

namespace {

// Stands in for a call into another mapper; see src/selvage.h for what the arguments mean.
selvage_status draw_with_my_mapper(const selvage_image* target, const selvage_rect* clip,
                                   const selvage_vertex* vertices, size_t count,
                                   const selvage_texture* texture, const selvage_options* options) {
  return selvage_draw(target, clip, vertices, count, texture, options);
}

[[nodiscard]] int broken_laws(const selvage::spec::Subject& subject) {
  using namespace selvage::spec;
  int broken = 0;
  for (const Law& law : laws()) {
    const LawVerdict verdict = verify(law, subject, /*first_seed=*/1, /*case_count=*/200);
    std::cout << law.name << ": " << verdict.judged_px << " px judged\n";
    if (!verdict.violation) continue;
    std::cout << explain(*verdict.violation);
    ++broken;
  }
  return broken;
}

TEST(YourMapper, ObeysTheLaws) { EXPECT_EQ(broken_laws({"mine", draw_with_my_mapper}), 0); }

// A mapper without filters says so, here and in its status; everything else is asked of it.
TEST(YourMapper, NeedsNoFilters) {
  const auto draw_nearest = [](const selvage_image* target, const selvage_rect* clip,
                               const selvage_vertex* vertices, size_t count,
                               const selvage_texture* texture,
                               const selvage_options* options) -> selvage_status {
    const bool known_profile =
        options != nullptr && options->profile >= 0 && options->profile <= SELVAGE_PROFILE_DKIT;
    if (known_profile && options->filter != SELVAGE_FILTER_NEAREST) return SELVAGE_ERROR_FILTER;
    return selvage_draw(target, clip, vertices, count, texture, options);
  };
  selvage::spec::Subject plain{"plain", draw_nearest};
  EXPECT_GT(broken_laws(plain), 0);
  plain.claims.filters = selvage::spec::only(SELVAGE_FILTER_NEAREST);
  EXPECT_EQ(broken_laws(plain), 0);
}

TEST(YourMapper, WouldBeToldWhatItDoesWrong) {
  const selvage::spec::Subject lazy{"lazy", [](auto...) { return SELVAGE_OK; }};
  EXPECT_GT(broken_laws(lazy), 0);
}

}  // namespace
