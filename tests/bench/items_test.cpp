// The work items are what they say they are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

#include "reports/bench/curves.h"
#include "reports/bench/inexact_loops.h"
#include "reports/bench/kernels.h"
#include "reports/bench/plan.h"
#include "reports/bench/spans.h"
#include "reports/bench/statistics.h"
#include "support.h"

namespace selvage::reports::test {
namespace {

bool everything(std::string_view, std::string_view) { return true; }

const Workload& find(const std::vector<Workload>& loads, const std::string& id) {
  for (const Workload& load : loads) {
    if (load.id == id) return load;
  }
  throw std::runtime_error("no item " + id);
}

ModelRows some_rows(const Workload& load, int32_t count) {
  return model_rows(load, sample_rows(load.target_side_px, count, 3), [] {});
}

double share_of_target(const Workload& load) {
  return static_cast<double>(count_covered(load)) / (1024.0 * 1024.0);
}

TEST(Items, AreThoseOfTheTable) {
  const auto loads = workloads(1);
  std::vector<std::string> ids;
  for (const Workload& load : loads) ids.push_back(load.id);
  EXPECT_EQ(ids,
            (std::vector<std::string>{"W1", "W1-2048", "W2", "W3", "W3-20000", "W4", "W4-2000",
                                      "W4-20000", "W4-rounded", "W5", "W6", "W7", "W8", "W9"}));
  EXPECT_NEAR(share_of_target(find(loads, "W1")), 0.5, 0.001);
  EXPECT_EQ(find(loads, "W1-2048").polygons.front().front().x,
            find(loads, "W1").polygons.front().front().x);
  EXPECT_EQ(find(loads, "W2").texture_side_texel, 2048);
  EXPECT_NEAR(share_of_target(find(loads, "W2")), 0.25, 0.001) << "512 px, 2048 texels: 4 x";
  EXPECT_EQ(find(loads, "W3").polygons.size(), 2000u);
  EXPECT_EQ(find(loads, "W3-20000").polygons.size(), 20000u);
  EXPECT_TRUE(find(loads, "W4").perspective);
  EXPECT_EQ(find(loads, "W4-2000").polygons.size(), 2000u);
  EXPECT_EQ(find(loads, "W4-20000").polygons.size(), 20000u);
  const Workload& mesh = find(loads, "W4-2000");
  for (const auto& triangle : mesh.polygons) {
    EXPECT_TRUE(triangle[0].q != triangle[1].q || triangle[0].q != triangle[2].q);
  }
  EXPECT_EQ(find(loads, "W5").filter, kBilinear);
  EXPECT_EQ(share_of_target(find(loads, "W6")), 1.0);
  EXPECT_EQ(find(loads, "W7").filter, kArea);
  EXPECT_EQ(find(loads, "W7").polygons.front().front().x,
            find(loads, "W2").polygons.front().front().x);
  EXPECT_EQ(find(loads, "W8").filter, kArea);
  EXPECT_TRUE(find(loads, "W8").perspective);
  EXPECT_TRUE(find(loads, "W4-rounded").perspective);
  EXPECT_NEAR(share_of_target(find(loads, "W4-rounded")), share_of_target(find(loads, "W4")), 0.01);
  EXPECT_EQ(find(loads, "W9").polygons.size(), 576u);
  EXPECT_NEAR(static_cast<double>(count_covered(find(loads, "W9"))) / 576, 28 * 28, 3);
}

// Of a map that all of a quad has, opposite corners' sums are alike, each times 1 / q.
TEST(Items, AreInNoPlaneWhereTheySaySo) {
  const auto loads = workloads(1);
  const auto& quad = find(loads, "W4-rounded").polygons.front();
  const auto w = [&](size_t i) { return 1.0 / quad[i].q; };
  const double off = (w(0) + w(2) - w(1) - w(3)) / w(0);
  EXPECT_NE(off, 0);
  EXPECT_LT(std::abs(off), 1e-5);
  int in_no_plane = 0;
  for (const auto& square : find(loads, "W9").polygons) {
    const int32_t x_off = square[0].x + square[2].x - square[1].x - square[3].x;
    const int32_t y_off = square[0].y + square[2].y - square[1].y - square[3].y;
    EXPECT_LE(std::max(std::abs(x_off), std::abs(y_off)), 2);
    in_no_plane += x_off != 0 || y_off != 0;
  }
  EXPECT_NEAR(in_no_plane, 576 / 2, 60);
}

TEST(Items, MoveTheirMeshesWithTheSeed) {
  EXPECT_EQ(find(workloads(1), "W3").polygons[7][1].x, find(workloads(1), "W3").polygons[7][1].x);
  EXPECT_NE(find(workloads(1), "W3").polygons[7][1].x, find(workloads(2), "W3").polygons[7][1].x);
}

// The least distance of a number from an integer above it, or from one at or below it.
double above(double x) { return x - std::floor(x); }
double below(double x) { return std::ceil(x) - x; }

TEST(Items, AreNearTiesWhereTheySaySo) {
  const auto loads = adversarial_workloads();
  const double most = std::ldexp(1, -21) * 1.01, least = std::ldexp(1, -32) * 0.99;
  for (const char* id : {"A1", "A6", "A11"}) {
    for (const auto& row : some_rows(find(loads, id), 8).pixels) {
      for (const ModelPixel& pixel : row) {
        for (const double x : {pixel.u, pixel.v})
          ASSERT_TRUE(below(x) <= most && below(x) >= least) << id << ' ' << below(x);
      }
    }
  }
  for (const auto& [id, least_log2] :
       {std::pair("A7", -22), std::pair("A8", -27), std::pair("A12", -32), std::pair("A13", -31)}) {
    for (const auto& row : some_rows(find(loads, id), 8).pixels) {
      for (const ModelPixel& pixel : row) {
        for (const double x : {pixel.u, pixel.v})
          ASSERT_TRUE(below(x) < std::ldexp(1, -16) && below(x) >= std::ldexp(1, least_log2))
              << id << ' ' << below(x);
      }
    }
  }
  for (const auto& row : some_rows(find(loads, "A2"), 8).pixels) {
    for (const ModelPixel& pixel : row) {
      for (const double x : {pixel.u, pixel.v})
        ASSERT_TRUE(above(x) <= most && above(x) >= least) << above(x);
    }
  }
  for (const auto& row : some_rows(find(loads, "A4"), 8).pixels) {
    for (const ModelPixel& pixel : row) ASSERT_EQ(pixel.u, 1024);
  }
  for (const auto& row : some_rows(find(loads, "A5"), 8).pixels) {
    for (const ModelPixel& pixel : row) ASSERT_TRUE(pixel.u == 1024 && pixel.v == 1024);
  }
  for (const auto& row : some_rows(find(loads, "A14"), 8).pixels) {
    for (const ModelPixel& pixel : row) ASSERT_TRUE(pixel.u == 1024 && pixel.v == 1024);
  }
}

TEST(Items, HaveTiesAtThirds) {
  const Workload load = find(adversarial_workloads(), "A3");
  size_t ties = 0, all = 0;
  for (const auto& row : some_rows(load, 32).pixels) {
    for (const ModelPixel& pixel : row) {
      ++all;
      ties += above(pixel.u) == 0 || above(pixel.v) == 0;
    }
  }
  EXPECT_NEAR(static_cast<double>(ties) / static_cast<double>(all), 5.0 / 9, 0.07);
}

TEST(Items, HaveNearTiesAtSixteenths) {
  const Workload load = find(adversarial_workloads(), "A10");
  const auto near = [](double x) { return std::min(above(x), below(x)) <= std::ldexp(1, -19); };
  std::vector<int32_t> period_px(16);
  std::iota(period_px.begin(), period_px.end(), 512);
  size_t near_ties = 0, all = 0;
  for (const auto& row : model_rows(load, period_px, [] {}).pixels) {
    for (const ModelPixel& pixel : row) {
      ++all;
      near_ties += near(pixel.u) || near(pixel.v);
    }
  }
  EXPECT_EQ(all, 16u * 1024);
  EXPECT_EQ(near_ties, all / 256 * 31);
}

TEST(Items, HaveTwinsWithoutNearTies) {
  const auto loads = adversarial_workloads();
  size_t twins = 0;
  for (const Workload& load : loads) {
    if (load.ordinary_id.empty()) continue;
    ++twins;
    const Workload& twin = find(loads, load.ordinary_id);
    EXPECT_EQ(twin.polygons.front().back().y, load.polygons.front().back().y);
    EXPECT_EQ(count_covered(twin), count_covered(load));
    // That of A10 has 16 samples a texel.
    const double least = load.id == "A10" ? 1.0 / 64 : 0.1;
    for (const auto& row : some_rows(twin, 4).pixels) {
      for (const ModelPixel& pixel : row)
        ASSERT_TRUE(above(pixel.u) > least && below(pixel.u) > least) << twin.id << ' ' << pixel.u;
    }
  }
  EXPECT_EQ(twins, 14u);
}

// The formula of spec/README.md, written out: weights of 1/256, halves rounded up.
int32_t bilinear_level(double u, double v, uint32_t channel) {
  const auto fu = static_cast<int32_t>(std::floor(256 * (u - 0.5)));
  const auto fv = static_cast<int32_t>(std::floor(256 * (v - 0.5)));
  const auto level = [&](int32_t s, int32_t t) {
    return static_cast<int32_t>(noise_of(s, t) >> channel & 0xFF);
  };
  const int32_t s = fu >> 8, t = fv >> 8, right = fu & 255, below = fv & 255;
  return (((256 - right) * level(s, t) + right * level(s + 1, t)) * (256 - below) +
          ((256 - right) * level(s, t + 1) + right * level(s + 1, t + 1)) * below + 32768) >>
         16;
}

TEST(Items, HaveAModelOfBilinear) {
  Workload load = small_workload({rectangle(2, 3, 20, 22, 0.3)});
  load.filter = kBilinear;
  size_t seen = 0;
  for (const auto& row : some_rows(load, 32).pixels) {
    for (const ModelPixel& pixel : row) {
      if (pixel.colour == kUntouched) continue;
      ++seen;
      for (const uint32_t channel : {0u, 8u, 16u})
        EXPECT_EQ(pixel.colour >> channel & 0xFF, bilinear_level(pixel.u, pixel.v, channel));
      EXPECT_EQ(pixel.colour >> 24, 0xFFu);
    }
  }
  EXPECT_EQ(seen, 18u * 19u);
}

TEST(Items, FilteredHaveANoisyTexture) {
  const Texture noise(64, texels_for(kBilinear));
  double sum = 0, sum_of_steps = 0;
  for (int32_t t = 0; t < 64; ++t) {
    for (int32_t s = 0; s < 64; ++s) {
      const uint32_t texel = noise.texels[static_cast<size_t>(t * noise.pitch_texel + s)];
      EXPECT_EQ(texel, noise_of(s, t));
      EXPECT_EQ(texel >> 24, 0xFFu);
      for (const uint32_t channel : {0u, 8u, 16u}) {
        const auto level = [&](uint32_t of) { return static_cast<int32_t>(of >> channel & 0xFF); };
        EXPECT_LE(level(texel), 254);
        sum += level(texel);
        sum_of_steps += std::abs(level(texel) - level(noise_of(s + 1, t)));
      }
    }
  }
  // Even and independent levels: the mean is half of the range, that of the steps a third.
  EXPECT_NEAR(sum / (3 * 64 * 64), 127, 5);
  EXPECT_NEAR(sum_of_steps / (3 * 64 * 64), 85, 5);
}

TEST(Items, OfCurvesHaveTheSizesTheySay) {
  const Curve sizes = curve_polygon_size();
  EXPECT_EQ(sizes.xs.front(), 1);
  EXPECT_EQ(sizes.xs.back(), 1 << 20);
  for (const double area : sizes.xs) {
    const Workload load = sizes.load_at(area);
    const double mean =
        static_cast<double>(count_covered(load)) / static_cast<double>(load.polygons.size());
    EXPECT_NEAR(mean / area, 1, 0.05) << area;
  }
  const Curve off_screen = curve_off_screen();
  for (const double ratio : off_screen.xs) {
    if (ratio == 1) continue;
    const Workload load = off_screen.load_at(ratio);
    EXPECT_EQ(share_of_target(load), 1.0);
    const double dx = load.polygons[0][1].x - load.polygons[0][0].x;
    const double dy = load.polygons[0][1].y - load.polygons[0][0].y;
    EXPECT_NEAR((dx * dx + dy * dy) / (256.0 * 256 * 1024 * 1024), ratio, ratio / 1000);
  }
  EXPECT_EQ(curve_texture_size().load_at(8192).texture_side_texel, 8192);
  EXPECT_EQ(curve_scale().load_at(16).polygons[0][1].u, 4096 * 65536);
}

TEST(Items, OfTheCurveOfThreadsAreTheWorkItemsUpToTwiceTheCores) {
  for (const char* id : {"W1", "W3"}) {
    const Curve curve = curve_threads(id);
    EXPECT_EQ(curve.id, std::string("threads-") + id);
    EXPECT_EQ(curve.xs.front(), 1);
    EXPECT_EQ(curve.xs.back(), 2 * std::max(std::thread::hardware_concurrency(), 1u));
    EXPECT_TRUE(std::is_sorted(curve.xs.begin(), curve.xs.end()));
    EXPECT_EQ(curve.load_at(2).polygons.size(), find(workloads(1), id).polygons.size());
    for (const Series& series : curve.series) EXPECT_TRUE(series.subject_at(2).threads);
  }
  EXPECT_THROW((void)curve_threads("W99"), std::logic_error);
}

TEST(Plan, HasEachItemOnceAndSaysWhatThereIsNot) {
  const Plan plan = make_plan(1, {.curves = true}, everything);
  std::set<std::string> ids;
  for (const Item& item : plan.items) EXPECT_TRUE(ids.insert(item.load.id).second) << item.load.id;
  const bool bilinear = mapper_takes(kBilinear);
  EXPECT_EQ(ids.contains("W5"), bilinear);
  const bool said =
      std::any_of(plan.unavailable.begin(), plan.unavailable.end(),
                  [](const std::string& sentence) { return sentence.rfind("W5 ", 0) == 0; });
  EXPECT_NE(said, bilinear);
  EXPECT_EQ(plan.work_items, 13u + (bilinear ? 1 : 0) + 28);
  EXPECT_EQ(plan.curves.size(), curves().size());
  EXPECT_EQ(plan.subjects.front().id, "exact");
  EXPECT_EQ(plan.subjects.back().id, "fill");
}

TEST(Plan, TakesWhatIsWantedOnly) {
  const Plan plan =
      make_plan(1, {.curves = true}, [](std::string_view item, std::string_view subject) {
        return (item == "W4" || item == "scale=2") && subject != "exact";
      });
  ASSERT_EQ(plan.items.size(), 2u);
  EXPECT_EQ(plan.work_items, 1u);
  ASSERT_EQ(plan.curves.size(), 1u);
  EXPECT_EQ(plan.curves[0].xs, std::vector<double>{2});
  EXPECT_EQ(plan.items[plan.curves[0].items[0]].load.id, "scale=2");
  for (const Subject& subject : plan.subjects) EXPECT_NE(subject.id, "exact");
}

TEST(Plan, HasKernelsWhereAskedFor) {
  const auto kernels_of = [](const Extras& extras) {
    std::vector<std::string> ids;
    for (const Subject& subject : make_plan(1, extras, everything).subjects) {
      if (subject.id.rfind("kernel-", 0) == 0) ids.push_back(subject.id.substr(7));
    }
    return ids;
  };
  EXPECT_EQ(kernels_of({}), std::vector<std::string>{});
  std::vector<std::string> here;
  for (const selvage_kernel kernel : kernels_here()) here.push_back(kernel_name(kernel));
  EXPECT_EQ(kernels_of({.kernels = true}), here);
  const auto loops_of = [](const Extras& extras) {
    const Plan plan = make_plan(1, extras, everything);
    return std::ranges::count_if(plan.subjects, [](const Subject& subject) {
      return std::ranges::any_of(inexact_loops(),
                                 [&](const InexactLoop& loop) { return loop.name == subject.id; });
    });
  };
  EXPECT_EQ(loops_of({}), 0);
  EXPECT_EQ(loops_of({.kernels = true}), static_cast<ptrdiff_t>(inexact_loops().size()));
  EXPECT_EQ(here.front(), "scalar");
  EXPECT_EQ(kernels_here().size() + kernels_elsewhere().size(), 5U);
}

TEST(FastestKernels, AreAnsweredForEachFilterAndWork) {
  const std::vector<FastestKernel> all = fastest_kernels();
  EXPECT_EQ(all.size(), 12U);
  for (const FastestKernel& one : all) {
    EXPECT_EQ(std::ranges::count(kernels_here(), one.kernel), 1) << one.filter << " " << one.work;
  }
}

TEST(Spread, IsMedianAndQuartiles) {
  const Spread spread = spread_of({5, 1, 4, 2, 3});
  EXPECT_EQ(spread.median, 3);
  EXPECT_EQ(spread.lower_quartile, 2);
  EXPECT_EQ(spread.upper_quartile, 4);
  EXPECT_EQ(spread_of({1, 2}).median, 1.5);
}

}  // namespace
}  // namespace selvage::reports::test
