// What a projective map is at most around a batch, against exact rational numbers at every pixel
// there.
#include "mapper/projective_box.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "spec/exact.h"
#include "spec/random.h"

namespace selvage::mapper {
namespace {

using spec::Rational;
using Form = ProjectiveField::Form;

[[nodiscard]] Rational exact_value(const Form& form, int32_t x, int32_t y) {
  return Rational(form.start) + x * Rational(form.step_x) + y * Rational(form.step_y);
}

[[nodiscard]] double any_up_to(spec::Random& random, double most) {
  return most * random.in(-1'000'000, 1'000'001) / 1e6;
}

// Of few pixels, so that all of them are asked.
[[nodiscard]] SpanBatch any_small_batch(spec::Random& random) {
  SpanBatch batch;
  batch.first_row = random.in(-20, 20);
  batch.rows = random.in(1, 7);
  const size_t full = static_cast<size_t>(random.in(0, batch.rows));
  for (size_t i = 0; i < static_cast<size_t>(batch.rows); ++i) {
    const bool empty = i != full && random.percent(20);
    batch.left_px[i] = random.in(-30, 30);
    batch.right_px[i] = batch.left_px[i] + (empty ? 0 : random.in(1, 12));
  }
  return batch;
}

// Of a denominator that is 1 or more, up to 4, in most boxes.
[[nodiscard]] ProjectiveField any_gentle_field(spec::Random& random, const SpanBatch& batch) {
  ProjectiveField field{};
  field.first_px = -30;
  field.first_row = batch.first_row - random.in(0, 3);
  const double most_turn = random.pick({0.0, 1e-4, 0.01, 0.02});
  field.denominator = {2, any_up_to(random, most_turn), any_up_to(random, most_turn)};
  const double u = any_up_to(random, random.pick({0.0, 0x1p40, 0x1p46}));
  const double step = random.pick({0.0, 1.0, 0x1p30, 0x1p34});
  const auto form = [&] {
    const Form& d = field.denominator;
    return Form{u * d.start, u * d.step_x + any_up_to(random, step),
                u * d.step_y + any_up_to(random, step)};
  };
  field.u_fx32 = form();
  field.v_fx32 = form();
  return field;
}

struct Found {
  Rational least, turn, steepest;
};

[[nodiscard]] Found found_in_box(const ProjectiveField& field, const SpanBatch& batch) {
  int32_t left_px = 100, right_px = -100;
  for (int32_t i = 0; i < batch.rows; ++i) {
    if (batch.span(i).empty()) continue;
    left_px = std::min(left_px, batch.span(i).left_px);
    right_px = std::max(right_px, batch.span(i).right_px);
  }
  Found found{100, 0, 0};
  for (int32_t i = 0; i < batch.rows; ++i) {
    for (int32_t px = left_px; px < right_px; ++px) {
      const int32_t x = px - field.first_px, y = batch.first_row + i - field.first_row;
      const Rational d = exact_value(field.denominator, x, y);
      found.least = std::min(found.least, d);
      if (d <= 0) return found;
      found.turn = std::max(found.turn, Rational(abs(Rational(field.denominator.step_x)) / d));
      for (const Form& form : {field.u_fx32, field.v_fx32}) {
        const Rational value = exact_value(form, x, y) / d;
        const Rational rise =
            (Rational(form.step_x) - value * Rational(field.denominator.step_x)) / d;
        found.steepest = std::max(found.steepest, Rational(abs(rise)));
      }
    }
  }
  return found;
}

TEST(ProjectiveBox, BoundsTheMapAtEveryPixelOfItAndIsNotMuchMore) {
  spec::Random random(1);
  const Rational barely = Rational(1) + Rational(0x1p-40);
  int positive = 0;
  for (int i = 0; i < 3000; ++i) {
    const SpanBatch batch = any_small_batch(random);
    const ProjectiveField field = any_gentle_field(random, batch);
    const ProjectiveBox box(field, batch);
    const Found found = found_in_box(field, batch);
    ASSERT_EQ(box.least_denominator > 0, found.least > 0) << i;
    if (found.least <= 0) continue;
    ++positive;
    ASSERT_NEAR(box.least_denominator, found.least.get_d(), 1e-12) << i;
    ASSERT_LE(found.turn, Rational(box.turn) * barely) << i;
    ASSERT_NEAR(box.turn, found.turn.get_d(), 1e-12) << i;
    ASSERT_LE(found.steepest, Rational(box.steepest_fx32) * barely) << i;
    // The largest numerator and the least denominator may be those of different corners.
    const double ratio = 1 + 40 * found.turn.get_d() + 8 * std::abs(field.denominator.step_y);
    ASSERT_LE(box.steepest_fx32, found.steepest.get_d() * ratio * ratio + 0x1p10) << i;
  }
  EXPECT_GT(positive, 2000);
}

}  // namespace
}  // namespace selvage::mapper
