// Law IDENTITY: what is not transformed is copied.
#include <algorithm>
#include <utility>

#include "spec/law_list.h"
#include "spec/law_tools.h"

namespace selvage::spec {
namespace {

// One side of the rectangle, [begin, end) fx8, on whole pixels where the profile wants them.
struct Side {
  int32_t begin_fx8, end_fx8;

  [[nodiscard]] bool covers(const Profile& profile, int32_t index_px) const {
    const int64_t sample_fx8 = sample_point(profile, index_px, index_px).x;
    return begin_fx8 <= sample_fx8 &&
           (profile.both_ends ? sample_fx8 <= end_fx8 : sample_fx8 < end_fx8);
  }
};

// Over the whole target, where what steps lose shows at the far end, or anywhere.
[[nodiscard]] Side pick_side(const Capabilities& claims, int32_t step_fx8, Choices& choices,
                             int32_t size_px) {
  if (choices.pick(0, 4) == 0) return {0, std::min(size_px, 8192) * SELVAGE_SUBPIXELS};
  const int32_t grid = ~(step_fx8 - 1);
  const int32_t reach = std::min(size_px + 2, 8192) * SELVAGE_SUBPIXELS;
  const int32_t begin = choices.pick(-2 * SELVAGE_SUBPIXELS, reach) & grid;
  const int32_t end = begin + (choices.pick(0, reach) & grid);
  return {in_guard_band(claims, begin, size_px), in_guard_band(claims, end, size_px)};
}

// A rectangle whose u - x and v - y are whole texels; where texels lie about whole u, its far side
// is at the last texel's centre.
[[nodiscard]] Case block_rectangle(const Capabilities& claims, const Case& c, Side columns,
                                   Side rows, int32_t ds, int32_t dt) {
  const bool last_centre = c.profile == SELVAGE_PROFILE_ABRASH57;
  const auto texel_fx16 = [&](int32_t at_fx8, const Side& side, int32_t shift) {
    const bool far = last_centre && at_fx8 == side.end_fx8 && side.begin_fx8 != side.end_fx8;
    return at_fx8 * 256 + (shift - (far ? 1 : 0)) * SELVAGE_SUBTEXELS;
  };
  const auto corner = [&](int32_t x, int32_t y) {
    return selvage_vertex{x, y, texel_fx16(x, columns, ds), texel_fx16(y, rows, dt),
                          1 + static_cast<int32_t>(c.choice % SELVAGE_Q_MAX)};
  };
  const auto [left, right] = columns;
  const auto [top, bottom] = rows;
  return with_vertices(
      claims, c,
      {corner(left, top), corner(right, top), corner(right, bottom), corner(left, bottom)});
}

}  // namespace

Judgement check_identity(const Subject& subject, const Case& any) {
  // The mean of four texels is no copy of one, nor is any that is not about its very centre.
  const bool is_copy = any.filter != SELVAGE_FILTER_FOUR && shows_exact_texels(subject.claims);
  const Case c = is_copy ? any : with_nearest(any);
  Choices choices(c.choice);
  const Profile& profile = profile_of(c);
  const int32_t step_fx8 = mapped_step_fx8(profile, subject.claims);
  const Side columns = pick_side(subject.claims, step_fx8, choices, c.target_width_px);
  const Side rows = pick_side(subject.claims, step_fx8, choices, c.target_height_px);
  const int32_t ds = choices.pick(-c.texture_width_texel, c.texture_width_texel + 1) % 1024;
  const int32_t dt = choices.pick(-c.texture_height_texel, c.texture_height_texel + 1) % 1024;
  const Case shown = visible(subject, block_rectangle(subject.claims, c, columns, rows, ds, dt));
  const bool is_flat = rows.begin_fx8 == rows.end_fx8;
  const Picture drawn = draw(subject, shown);
  const auto wanted = [&](int32_t x, int32_t y) {
    const bool is_covered = !is_flat && columns.covers(profile, x) && rows.covers(profile, y);
    if (!is_covered || !is_visible(c, {x, y})) return must_be(std::nullopt);
    return must_be(addressed_value(c, {x + ds, y + dt}));
  };
  return compare("IDENTITY", "an axis-aligned one-to-one rectangle is a block copy", shown, drawn,
                 without_doubt(subject.claims.coverage_accuracy_fx16, shown, drawn, wanted));
}

}  // namespace selvage::spec
