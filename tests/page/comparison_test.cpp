// What the page says of a recorded baseline, from numbers that are written down here.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "contains.h"
#include "reports/page/measurements.h"

namespace selvage::reports {
namespace {

using json = nlohmann::ordered_json;

[[nodiscard]] json bench_against(int then_px, int now_px) {
  return {{"padding_px", now_px},
          {"subjects", {{{"id", "exact"}}}},
          {"workloads", {{{"id", "W1"}}}},
          {"comparison",
           {{"baseline", "then.json"},
            {"date", "a day"},
            {"cpu", "an abacus"},
            {"compiler", "a clerk"},
            {"padding_px", then_px},
            {"times", {{{"item", "W1"}, {"subject", "exact"}, {"ratio", 0.5}}}}}}};
}

TEST(Comparison, IsOfTheTimesThenAndNow) {
  const std::string html = comparison_part(bench_against(16, 16));
  EXPECT_TRUE(contains(html, "those of then.json (a day, an abacus, a clerk)")) << html;
  EXPECT_TRUE(contains(html, ">0.500<")) << html;
}

TEST(Comparison, SaysWhereTheTargetsWerePaddedOtherwise) {
  EXPECT_TRUE(contains(comparison_part(bench_against(0, 16)),
                       "The rows of its targets were padded by 0 px, now by 16 px"));
  EXPECT_FALSE(contains(comparison_part(bench_against(16, 16)), "padded"));
}

}  // namespace
}  // namespace selvage::reports
