// What the page says of where the exact mapper stands, from numbers that are written down here.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "contains.h"
#include "reports/page/measurements.h"

namespace selvage::reports {
namespace {

using json = nlohmann::ordered_json;

[[nodiscard]] json result(const std::string& id, double ns) {
  return {{"id", id}, {"ns_per_px", {{"median", ns}}}};
}

[[nodiscard]] json bench_of(json results) {
  const auto subject = [](const std::string& id, const std::string& group) {
    return json{{"id", id}, {"group", group}};
  };
  return {{"subjects",
           {subject("exact", "ours"), subject("inexact", "usual"), subject("Slow", "peers"),
            subject("Quick", "peers"), subject("Absent", "peers"), subject("fill", "limits")}},
          {"workloads", {{{"id", "W1"}, {"ordinary", nullptr}, {"results", std::move(results)}}}}};
}

TEST(Standing, IsByFillByInexactAndByTheFastestPeer) {
  const json refused{{"id", "Absent"}, {"refusal", "it knows no perspective"}};
  const std::string html = standing_part(
      bench_of({result("exact", 0.5), result("exact-many", 0.375), result("inexact", 0.4),
                result("Slow", 9), result("Quick", 1.5), refused, result("fill", 0.25)}));
  EXPECT_TRUE(contains(html, ">0.500 ns<")) << html;
  EXPECT_TRUE(contains(html, ">2.00<")) << "by fill: " << html;
  EXPECT_TRUE(contains(html, ">1.25<")) << "by inexact: " << html;
  EXPECT_TRUE(contains(html, ">Quick, 1.50 ns<")) << html;
  EXPECT_TRUE(contains(html, ">3.00<")) << "the peer by exact: " << html;
  EXPECT_TRUE(contains(html, ">0.375 ns<")) << "in one call: " << html;
  EXPECT_TRUE(contains(html, ">4.00<")) << "the peer by one call: " << html;
  EXPECT_FALSE(contains(html, "Slow")) << html;
}

TEST(Standing, LeavesOutWhatWasNotMeasured) {
  EXPECT_EQ(standing_part(bench_of({result("fill", 1), result("Quick", 1)})), "");
  const std::string alone = standing_part(bench_of({result("exact", 0.5)}));
  EXPECT_TRUE(contains(alone, ">0.500 ns<"));
  EXPECT_TRUE(contains(alone, "&ndash;"));
  EXPECT_FALSE(contains(alone, ">1.00<"));
  EXPECT_FALSE(contains(alone, ">0.00<")) << "nothing is divided by what was not measured";
}

}  // namespace
}  // namespace selvage::reports
