// Errors counted by the benchmark, on drawings whose errors are known.
#include <gtest/gtest.h>

#include "reports/bench/double_drawn.h"
#include "reports/bench/outlines.h"
#include "reports/bench/spans.h"
#include "support.h"

namespace selvage::reports::test {
namespace {

const ErrorCount& errors_of(const std::vector<ItemResult>& results, size_t subject = 0) {
  return *results.at(0).cells.at(subject).errors;
}

std::vector<ItemResult> measured(const Plan& plan) {
  return measure(plan, quick_settings(), ignore_progress);
}

TEST(Judging, CountsNoErrorsOfAnExactDrawing) {
  const Plan plan = plan_of(small_workload({rectangle(2, 3, 10, 12)}),
                            {subject_exact(), box_subject("b", 0, 0), subject_exact_many(1)});
  const auto results = measured(plan);
  EXPECT_EQ(results[0].covered_px, 72u);
  for (const size_t subject : {0u, 1u, 2u}) {
    const ErrorCount& errors = errors_of(results, subject);
    EXPECT_EQ(errors.total(), 0u);
    EXPECT_EQ(errors.judged_px, 32u * 32u);
    EXPECT_EQ(errors.covered_px, 72u);
    EXPECT_EQ(errors.compared_px, 72u);
    EXPECT_FALSE(errors.double_px) << "one polygon";
    EXPECT_GT(results[0].cells[subject].ns_per_px.median, 0);
  }
}

TEST(Judging, CountsWrongTexelsAndTheirDistances) {
  const Plan plan = plan_of(small_workload({rectangle(2, 3, 10, 12)}), {box_subject("b", 0, 3)});
  const auto results = measured(plan);
  const ErrorCount& errors = errors_of(results);
  EXPECT_EQ(errors.wrong_texels, 72u);
  EXPECT_EQ(errors.largest_texel, 3);
  EXPECT_DOUBLE_EQ(errors.mean_texel(), 3.0);
  // u = s + 1/2 is two and a half texels left of the texel three further right.
  EXPECT_DOUBLE_EQ(errors.largest_coordinate_texel, 2.5);
}

TEST(Judging, CountsPixelsMissingAndExtra) {
  const Plan plan = plan_of(small_workload({rectangle(2, 3, 10, 12)}),
                            {box_subject("wide", 1, 0), box_subject("narrow", -2, 0)});
  const auto results = measured(plan);
  EXPECT_EQ(errors_of(results, 0).extra_px, 9u);
  EXPECT_EQ(errors_of(results, 0).missing_px, 0u);
  EXPECT_EQ(errors_of(results, 1).extra_px, 0u);
  EXPECT_EQ(errors_of(results, 1).missing_px, 18u);
}

TEST(Judging, CountsPixelsThatTwoPolygonsDraw) {
  const auto tiles = small_workload({rectangle(2, 2, 6, 8), rectangle(6, 2, 9, 8)});
  const Plan plan = plan_of(
      tiles, {box_subject("wide", 1, 0), subject_exact(), subject_fill(), subject_exact_many(3)});
  const auto results = measured(plan);
  EXPECT_EQ(errors_of(results, 0).double_px, 6u) << "the first column of the second tile";
  EXPECT_EQ(errors_of(results, 0).extra_px, 6u) << "right of the second tile";
  EXPECT_EQ(errors_of(results, 1).double_px, 0u);
  EXPECT_EQ(errors_of(results, 2).double_px, 0u);
  EXPECT_EQ(errors_of(results, 3).total(), 0u);
}

TEST(Judging, DrawsPolygonsApartThatAreNear) {
  Workload load = small_workload({});
  load.target_side_px = 256;
  load.polygons = jittered_mesh(12, 9, 256, 64, 5);
  const auto classes = apart(load);
  size_t count = 0;
  for (const Workload& one : classes) {
    count += one.polygons.size();
    std::vector<int> drawn(256 * 256);
    for (const auto& polygon : one.polygons) {
      for_each_span(polygon, 256, 256, [&](const Span& span) {
        for (int32_t x = span.left_px - kApart_px; x < span.right_px; ++x)
          ++drawn[static_cast<size_t>(span.y_px * 256 + x)];
      });
    }
    EXPECT_EQ(std::count_if(drawn.begin(), drawn.end(), [](int times) { return times > 1; }), 0);
  }
  EXPECT_EQ(count, load.polygons.size());
  EXPECT_LT(classes.size(), 20u);
}

// The point of A7 and A8 amid its range: along each row or column u falls, and v rises, past it.
Workload crossing(Workload load) {
  constexpr int32_t kPoint_fx16 = 1024 * SELVAGE_SUBTEXELS;
  for (auto& polygon : load.polygons) {
    for (selvage_vertex& vertex : polygon) {
      vertex.u = kPoint_fx16 + 2 * (vertex.u - kPoint_fx16) + 1;
      vertex.v = kPoint_fx16 - 2 * (vertex.v - kPoint_fx16) - 1;
    }
  }
  load.id += "-crossing";
  return load;
}

// Near-ties are where kernels part: measure() throws where one of them is not exact.
TEST(Judging, FindsEachKernelExactOnNearTies) {
  Plan plan;
  for (Workload& load : adversarial_workloads()) {
    if (load.ordinary_id.empty()) continue;
    if (load.id == "A7" || load.id == "A8")
      plan.items.push_back({crossing(load), subjects_by_kernel()});
    plan.items.push_back({std::move(load), subjects_by_kernel()});
  }
  plan.work_items = plan.items.size();
  BenchSettings settings = quick_settings();
  settings.timing.repetitions = 1;
  for (const ItemResult& item : measure(plan, settings, ignore_progress)) {
    for (const Cell& cell : item.cells) {
      EXPECT_GT(cell.errors->covered_px, 0u);
      EXPECT_EQ(cell.errors->total(), 0u) << item.load->id << ' ' << cell.subject->id;
    }
  }
}

TEST(Judging, StopsAtAReferenceThatErrs) {
  Subject wrong = box_subject("mine", 0, 1);
  wrong.reference = true;
  const Plan plan = plan_of(small_workload({rectangle(2, 3, 10, 12)}), {wrong});
  try {
    (void)measured(plan);
    FAIL() << "a wrong reference was timed";
  } catch (const WrongAnswer& error) {
    EXPECT_NE(std::string(error.what()).find("small: 'mine' is not what it must be"),
              std::string::npos);
  }
}

// Samples at u = s + 1/2 + off, drawn with texel s + 1: the coordinate is 1/2 - off too low for it.
TEST(Judging, TakesTheToleranceOfAReferenceAtItsWord) {
  Subject tolerant = box_subject("mine", 0, 1);
  tolerant.reference = true;
  tolerant.tolerance_texel = 0.25;
  const auto load_off = [](double off) {
    Workload load = small_workload({rectangle(2, 3, 10, 12, off)});
    return load;
  };
  const Plan within = plan_of(load_off(0.3), {tolerant});
  EXPECT_DOUBLE_EQ(errors_of(measured(within)).largest_coordinate_texel,
                   0.5 - static_cast<int>(0.3 * 65536) / 65536.0);
  const Plan beyond = plan_of(load_off(0.2), {tolerant});
  EXPECT_THROW((void)measured(beyond), WrongAnswer);
}

// Only nearest makes use of a tolerance, so that filtered it is held to the exact colours.
TEST(Judging, HoldsTheTolerantToTheExactColoursOfFilters) {
  for (const selvage_filter filter : {kBilinear, kArea}) {
    Workload load = small_workload({rectangle(2, 3, 10, 12, 0.3)});
    load.filter = filter;
    const auto results = measured(plan_of(load, subjects_tolerant()));
    for (const auto& cell : results[0].cells) {
      EXPECT_EQ(cell.refusal, "");
      ASSERT_TRUE(cell.errors);
      EXPECT_GT(cell.errors->compared_px, 0u);
      EXPECT_EQ(cell.errors->total(), 0u);
    }
  }
}

TEST(Judging, LeavesLimitsAndRefusalsUnjudged) {
  Subject refuser = box_subject("refuser", 0, 0);
  refuser.refusal = [](const Workload&) { return std::string("no reason"); };
  const Plan plan = plan_of(small_workload({rectangle(2, 3, 10, 12)}),
                            {refuser, subject_memcpy(), subject_fill()});
  const auto results = measured(plan);
  const auto& cells = results[0].cells;
  EXPECT_EQ(cells[0].refusal, "no reason");
  EXPECT_EQ(results[0].measured("refuser"), nullptr);
  EXPECT_FALSE(cells[1].errors);
  EXPECT_GT(cells[1].ns_per_px.median, 0);
  EXPECT_EQ(cells[2].errors->compared_px, 0u) << "the fill has no texels to compare";
  EXPECT_TRUE(ratio(results[0].measured("memcpy"), results[0].measured("fill")));
  EXPECT_FALSE(ratio(results[0].measured("memcpy"), results[0].measured("exact")));
}

TEST(Judging, RefusesFiltersForThoseThatCannot) {
  Workload load = small_workload({rectangle(2, 3, 10, 12)});
  load.filter = kBilinear;
  const Plan plan = plan_of(load, {box_subject("b", 0, 0), subject_fill()});
  const auto results = measured(plan);
  EXPECT_EQ(results[0].cells[0].refusal, "it is not drawn bilinearly here");
  EXPECT_EQ(results[0].cells[1].refusal, "");
}

}  // namespace
}  // namespace selvage::reports::test
