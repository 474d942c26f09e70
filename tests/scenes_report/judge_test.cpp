// The judge of pixels: what it measures, and that it notices what is wrong.
#include "reports/scenes/judge.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <memory>

#include "reports/scenes/study.h"
#include "tests/page/contains.h"

namespace selvage::reports {
namespace {

using spec::Rational;

TEST(Distance, IsToTheTexelAndAroundATextureThatWraps) {
  const auto wrapped = [](double u, int32_t texel) {
    return distance_texel(Rational(u), texel, 64, SELVAGE_ADDRESS_WRAP);
  };
  EXPECT_EQ(wrapped(5, 5), 0);
  EXPECT_EQ(wrapped(5.75, 5), 0);
  EXPECT_EQ(wrapped(6.25, 5), 0.25);
  EXPECT_EQ(wrapped(4.5, 5), 0.5);
  EXPECT_EQ(wrapped(64.5, 0), 0);
  EXPECT_EQ(wrapped(-0.5, 63), 0);
  EXPECT_EQ(wrapped(-0.5, 0), 0.5);
  EXPECT_EQ(wrapped(64.25, 63), 0.25);
  EXPECT_EQ(wrapped(1000.5, 1000 % 64), 0);

  const auto clamped = [](double u, int32_t texel) {
    return distance_texel(Rational(u), texel, 64, SELVAGE_ADDRESS_CLAMP);
  };
  EXPECT_EQ(clamped(-7, 0), 0);
  EXPECT_EQ(clamped(70, 63), 0);
  EXPECT_EQ(clamped(70, 62), 7);
  EXPECT_EQ(clamped(3.5, 2), 0.5);
}

[[nodiscard]] JudgedPixel sound() {
  JudgedPixel pixel;
  pixel.x_px = 12;
  pixel.y_px = 34;
  pixel.choice = Choice::kSubdivided;
  pixel.measured_texel = 0.125;
  pixel.bound_texel = 0.125;
  pixel.tolerance_texel = 0.25;
  pixel.wrong_texel = true;
  return pixel;
}

TEST(Breach, IsNoneOfAPixelWithinItsBoundAndThatWithinTheTolerance) {
  EXPECT_EQ(breach(sound()), std::nullopt);
  JudgedPixel exact = sound();
  exact.measured_texel = exact.bound_texel = exact.tolerance_texel = 0;
  exact.wrong_texel = false;
  EXPECT_EQ(breach(exact), std::nullopt);
}

TEST(Breach, NamesWhatIsBroken) {
  JudgedPixel pixel = sound();
  pixel.measured_texel = 0.126;
  ASSERT_TRUE(breach(pixel));
  EXPECT_EQ(*breach(pixel),
            "pixel (12, 34), subdivided: measured 0.126 texel is above the bound, 0.125 texel");

  pixel = sound();
  pixel.bound_texel = 0.5;
  ASSERT_TRUE(breach(pixel));
  EXPECT_TRUE(contains(*breach(pixel), "the bound, 0.5 texel, is above the tolerance, 0.25 texel"));

  pixel = sound();  // next to a texel's border: nothing measurable, yet not the exact texel
  pixel.measured_texel = pixel.bound_texel = 0;
  ASSERT_TRUE(breach(pixel));
  EXPECT_TRUE(contains(*breach(pixel), "beside the exact one"));

  pixel = sound();
  pixel.measured_texel = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(breach(pixel));

  pixel = sound();
  pixel.right_colour = false;
  ASSERT_TRUE(breach(pixel));
  EXPECT_TRUE(contains(*breach(pixel), "colour"));

  pixel = sound();
  pixel.right_surface = false;
  ASSERT_TRUE(breach(pixel));
  EXPECT_TRUE(contains(*breach(pixel), "not that of the face that shows"));
}

inline constexpr scene::Size kSize{80, 60};

// A shipped scene, drawn small; what was drawn can be spoilt before it is judged.
class Judged {
 public:
  Judged(size_t shipped, double tolerance_texel, std::optional<selvage_filter> filter)
      : scene_(read_shipped(SELVAGE_SHIPPED, kShipped[shipped])),
        drawing_(compose(scene_, 0, kSize, {tolerance_texel, filter}, scene::Hidden::kScanLine)),
        exact_(exact_view(drawing_.view, kSize)),
        choices_(scene_, drawing_, kSize),
        drawn_(draw_both(scene_, drawing_, kSize)) {}

  [[nodiscard]] Verdict verdict(double tolerance_texel) const {
    return judge(scene_, drawing_, exact_, choices_, drawn_, tolerance_texel);
  }
  [[nodiscard]] Drawn& drawn() { return drawn_; }

  // As a mapper would that is so many texels off; of a scene with one texture and no light.
  void show_texel_beside(size_t pixel, uint32_t columns) {
    const scene::TextureImage& texture = scene_.textures.at(0);
    const uint32_t place = drawn_.places[pixel] += columns;
    const size_t texel =
        (place >> 16) * static_cast<size_t>(texture.width_texel) + (place & 0xFFFF);
    std::memcpy(drawn_.picture.rgba.data() + 4 * pixel, texture.rgba.data() + 4 * texel, 4);
  }

  // The first pixel of that kind, as its number.
  [[nodiscard]] size_t first(Choice choice) const {
    for (size_t i = 0; i < exact_.pixels.size(); ++i) {
      const auto y_px = static_cast<int32_t>(i) / kSize.width_px;
      if (exact_.pixels[i].face && choices_.at(*exact_.pixels[i].face, y_px).choice == choice)
        return i;
    }
    ADD_FAILURE() << "no pixel is drawn by " << style_of(choice).id;
    return 0;
  }

 private:
  scene::Scene scene_;
  scene::Drawing drawing_;
  ExactView exact_;
  RowChoices choices_;
  Drawn drawn_;
};

TEST(Judge, FindsNothingWrongWithTheMapper) {
  for (size_t shipped = 0; shipped < kShipped.size(); ++shipped) {
    SCOPED_TRACE(kShipped[shipped].id);
    for (const std::optional<selvage_filter> filter :
         {std::optional<selvage_filter>{}, std::optional<selvage_filter>{SELVAGE_FILTER_NEAREST}}) {
      const Verdict exact = Judged(shipped, 0, filter).verdict(0);
      EXPECT_EQ(exact.first_breach, "");
      EXPECT_EQ(exact.wrong_texels, 0u);
      EXPECT_EQ(exact.largest_texel, 0);
      EXPECT_GT(exact.textured_px, 100u);
      const Verdict within = Judged(shipped, 4, filter).verdict(4);
      EXPECT_EQ(within.first_breach, "");
      EXPECT_GT(within.largest_texel, 0);
      EXPECT_LE(within.largest_texel, within.bound_texel);
      EXPECT_LE(within.bound_texel, 4);
    }
  }
}

// A texel beside the one that was drawn, and its colour, at one pixel: more than any bound of this
// drawing.
TEST(Judge, NoticesATexelThatIsNotWithinTheBound) {
  Judged globe(1, 0.25, SELVAGE_FILTER_NEAREST);
  ASSERT_EQ(globe.verdict(0.25).breaches, 0u);
  globe.show_texel_beside(globe.first(Choice::kAffineFaceNearest), 3);
  const Verdict verdict = globe.verdict(0.25);
  EXPECT_EQ(verdict.breaches, 1u);
  EXPECT_TRUE(contains(verdict.first_breach, "affine-face-nearest: measured 2.") &&
              contains(verdict.first_breach, "texel is above the bound, 0.2"))
      << verdict.first_breach;
  EXPECT_GT(verdict.largest_texel, 2);
}

// The planner took more than it was given.
TEST(Judge, NoticesABoundAboveTheTolerance) {
  const Verdict verdict = Judged(1, 1, SELVAGE_FILTER_NEAREST).verdict(0.0625);
  EXPECT_GT(verdict.breaches, 100u);
  EXPECT_TRUE(contains(verdict.first_breach, "is above the tolerance, 0.0625 texel"))
      << verdict.first_breach;
}

TEST(Judge, NoticesAPixelThatIsMissingAndOneThatIsTooMany) {
  Judged globe(1, 0, SELVAGE_FILTER_NEAREST);
  globe.drawn().places[globe.first(Choice::kExactNearest)] = kNoPlace;
  globe.drawn().places[0] = 0;
  const Verdict verdict = globe.verdict(0);
  EXPECT_EQ(verdict.breaches, 2u);
  EXPECT_TRUE(contains(verdict.first_breach, "pixel (0, 0)")) << verdict.first_breach;
}

TEST(Judge, NoticesAColourOfAFilterAndOfAPlainFaceAndOfTheBackground) {
  Judged station(0, 0, std::nullopt);
  for (const size_t at :
       {size_t{0}, station.first(Choice::kExactFiltered), station.first(Choice::kOneColour)})
    station.drawn().picture.rgba[4 * at + 1] ^= 1;
  EXPECT_EQ(station.verdict(0).breaches, 3u);
}

TEST(Breaches, AreNamedBySceneFilterAndTolerance) {
  std::vector<std::unique_ptr<Study>> studies;
  studies.push_back(std::make_unique<Study>());
  studies[0]->shipped = &kShipped[1];
  studies[0]->trials.resize(2);
  studies[0]->trials[1].filter = "auto";
  studies[0]->trials[1].tolerance_texel = 0.0625;
  EXPECT_TRUE(breaches(studies).empty());
  studies[0]->trials[1].verdict.breaches = 7;
  studies[0]->trials[1].verdict.first_breach = "something";
  ASSERT_EQ(breaches(studies).size(), 1u);
  EXPECT_EQ(breaches(studies)[0], "globe, filter auto, tolerance 1/16: something; 7 such pixels");
}

}  // namespace
}  // namespace selvage::reports
