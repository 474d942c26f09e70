#include <algorithm>
#include <cstdint>
#include <utility>

#include "spec/complexity.h"
#include "spec/generate.h"

namespace selvage::spec {
namespace {

class Candidates {
 public:
  explicit Candidates(const Case& c) : from_(c), limit_(complexity(c)) {}

  // Keeps the changed case if it is less complex.
  template <typename Change>
  void offer(const Change& change) {
    Case changed = from_;
    change(changed);
    if (complexity(changed) < limit_) list_.push_back(std::move(changed));
  }

  template <typename Field>
  void offer_value(Field Case::*field, Field value) {
    offer([&](Case& c) { c.*field = value; });
  }

  [[nodiscard]] std::vector<Case> take() { return std::move(list_); }

 private:
  const Case& from_;
  Complexity limit_;
  std::vector<Case> list_;
};

// Whole values nearer to zero, by less and less: in shares of the value, so that even a bound far
// from zero is come near in few steps.
[[nodiscard]] std::vector<int64_t> nearer_to_zero(int64_t value) {
  if (value == 0) return {};
  std::vector<int64_t> values;
  const int64_t one = value < 0 ? -1 : 1;
  for (const int64_t nearer : {int64_t{0}, value / 2, value - value / 4, value - value / 32,
                               value - value / 1024, value - one}) {
    const bool known = std::find(values.begin(), values.end(), nearer) != values.end();
    if (nearer != value && !known) values.push_back(nearer);
  }
  return values;
}

// Whole values nearer to zero; of a value with a fraction the whole part, the value without its
// last binary place, and values nearer to zero with the same fraction.
[[nodiscard]] std::vector<int32_t> rounder(int32_t value, int32_t unit) {
  const int32_t whole = value / unit, fraction = value % unit;
  std::vector<int32_t> values;
  if (fraction == 0) {
    for (const int64_t nearer : nearer_to_zero(whole)) {
      values.push_back(static_cast<int32_t>(nearer * unit));
    }
    return values;
  }
  const int32_t last_place = fraction & -fraction;
  const int32_t sign = value < 0 ? -1 : 1;
  values = {whole * unit, value - sign * last_place};
  if (whole == 0) values.push_back(sign * unit);
  for (const int64_t nearer : nearer_to_zero(whole)) {
    values.push_back(static_cast<int32_t>(nearer * unit) + fraction);
  }
  return values;
}

// Moves what is drawn by whole pixels; what would leave its range stops at the end of it.
void move_outline(Case& c, int64_t dx_px, int64_t dy_px) {
  const auto position = [](int32_t at_fx8, int64_t by_px) {
    return static_cast<int32_t>(
        std::clamp<int64_t>(at_fx8 + by_px * SELVAGE_SUBPIXELS, SELVAGE_X_MIN, SELVAGE_X_END - 1));
  };
  const auto side = [&](int32_t at_px, int64_t by_px) {
    return static_cast<int32_t>(
        std::clamp<int64_t>(at_px + by_px, kClipLeast_px, kClipGreatest_px));
  };
  for (selvage_vertex& vertex : c.vertices) {
    vertex.x = position(vertex.x, dx_px);
    vertex.y = position(vertex.y, dy_px);
  }
  if (!c.has_clip) return;
  c.clip = {side(c.clip.left, dx_px), side(c.clip.top, dy_px), side(c.clip.right, dx_px),
            side(c.clip.bottom, dy_px)};
}

// Runs of half of the vertices, of a quarter, ... of one.
void drop_vertices(const Case& c, Candidates& candidates) {
  const size_t count = c.vertices.size();
  for (size_t length = count == 1 ? 1 : count / 2; length > 0; length /= 2) {
    for (size_t at = 0; at < count; at += length) {
      candidates.offer([&](Case& fewer) {
        const auto first = fewer.vertices.begin() + static_cast<std::ptrdiff_t>(at);
        const size_t run = std::min(length, count - at);
        fewer.vertices.erase(first, first + static_cast<std::ptrdiff_t>(run));
      });
    }
  }
}

// Laws choose by Case::choice at random: any of a few numbers is as good as another.
constexpr uint32_t kFewChoices = 12;
// For what a law chooses may not fit into less of a target.
constexpr uint32_t kChoicesOfATarget = 4;

// Keeps the left or the right half of the target, the upper or the lower, three quarters, or all
// but one line.
void shrink_target(const Case& c, Candidates& candidates) {
  const auto shrink = [&](int32_t Case::*side, int64_t dx, int64_t dy) {
    const int32_t size = c.*side;
    for (const int32_t kept : {size / 2, size - size / 4, size - 1}) {
      if (kept < 1) continue;
      candidates.offer_value(side, kept);
      candidates.offer([&](Case& far) {
        far.*side = kept;
        move_outline(far, dx * (kept - size), dy * (kept - size));
      });
      for (uint32_t choice = 0; choice < kChoicesOfATarget; ++choice) {
        candidates.offer([&](Case& other) {
          other.*side = kept;
          other.choice = choice;
        });
      }
    }
  };
  shrink(&Case::target_width_px, 1, 0);
  shrink(&Case::target_height_px, 0, 1);
}

// Keeps the first texels of an axis, or the last: then the coordinates move with them.
void shrink_texture(const Case& c, Candidates& candidates) {
  const auto shrink = [&](int32_t Case::*side, int32_t selvage_vertex::*field) {
    for (const int32_t size : {1, c.*side / 2, c.*side - 1}) {
      if (size < 1) continue;
      candidates.offer_value(side, size);
      candidates.offer([&](Case& last) {
        const int64_t dropped_fx16 = int64_t{c.*side - size} * SELVAGE_SUBTEXELS;
        last.*side = size;
        for (selvage_vertex& vertex : last.vertices) {
          const int64_t value = vertex.*field - dropped_fx16;
          vertex.*field = static_cast<int32_t>(std::max<int64_t>(value, INT32_MIN));
        }
      });
    }
  };
  shrink(&Case::texture_width_texel, &selvage_vertex::u);
  shrink(&Case::texture_height_texel, &selvage_vertex::v);
}

void plain_options(const Case& c, Candidates& candidates) {
  candidates.offer([](Case& unclipped) {
    unclipped.has_clip = false;
    unclipped.clip = {};
  });
  candidates.offer_value(&Case::format, selvage_format{SELVAGE_RGBA8888});
  candidates.offer_value(&Case::address, selvage_address{SELVAGE_ADDRESS_CLAMP});
  for (selvage_filter simple = SELVAGE_FILTER_NEAREST; simple < c.filter; ++simple) {
    candidates.offer_value(&Case::filter, simple);
  }
  candidates.offer_value(&Case::layout, Layout::kGiven);
  candidates.offer_value(&Case::layout, Layout::kPadded);
  candidates.offer_value(&Case::flip_target, false);
  candidates.offer_value(&Case::flip_texture, false);
  for (const int64_t padding : nearer_to_zero(c.padding_px)) {
    candidates.offer_value(&Case::padding_px, static_cast<int32_t>(padding));
  }
  for (uint32_t choice = 0; choice < std::min(c.choice, kFewChoices); ++choice) {
    candidates.offer_value(&Case::choice, choice);
  }
  for (const int64_t choice : nearer_to_zero(c.choice)) {
    candidates.offer_value(&Case::choice, static_cast<uint32_t>(choice));
  }
}

void shrink_clip(const Case& c, Candidates& candidates) {
  candidates.offer([&](Case& within) {
    within.clip = {std::max(c.clip.left, 0), std::max(c.clip.top, 0),
                   std::min(c.clip.right, c.target_width_px),
                   std::min(c.clip.bottom, c.target_height_px)};
  });
  for (const auto side :
       {&selvage_rect::left, &selvage_rect::top, &selvage_rect::right, &selvage_rect::bottom}) {
    for (const int64_t nearer : nearer_to_zero(c.clip.*side)) {
      candidates.offer([&](Case& moved) { moved.clip.*side = static_cast<int32_t>(nearer); });
    }
  }
}

[[nodiscard]] int32_t least(const Case& c, int32_t selvage_vertex::*field) {
  const auto lower = [&](const selvage_vertex& a, const selvage_vertex& b) {
    return a.*field < b.*field;
  };
  return (*std::min_element(c.vertices.begin(), c.vertices.end(), lower)).*field;
}

// One field of all vertices toward zero: to nothing, to whole units, to halves.
void round_field(int32_t selvage_vertex::*field, int32_t unit, Candidates& candidates) {
  constexpr int64_t kBeyondAll = int64_t{1} << 32;
  for (const int64_t step : {kBeyondAll, int64_t{unit}, int64_t{unit} / 2}) {
    candidates.offer([&](Case& changed) {
      for (selvage_vertex& vertex : changed.vertices) {
        vertex.*field = static_cast<int32_t>(vertex.*field / step * step);
      }
    });
  }
}

// Texture coordinates of all vertices by the same whole texels, so that the least comes near zero.
void move_to_zero(const Case& c, int32_t selvage_vertex::*field, Candidates& candidates) {
  const int64_t whole = least(c, field) / SELVAGE_SUBTEXELS * SELVAGE_SUBTEXELS;
  candidates.offer([&](Case& moved) {
    for (selvage_vertex& vertex : moved.vertices) {
      const int64_t value = vertex.*field - whole;
      vertex.*field = static_cast<int32_t>(std::min<int64_t>(value, INT32_MAX));
    }
  });
}

void simplify_outline(const Case& c, Candidates& candidates) {
  if (c.vertices.empty()) return;
  for (const int32_t q : {1, least(c, &selvage_vertex::q)}) {
    candidates.offer([&](Case& affine) {
      for (selvage_vertex& vertex : affine.vertices) vertex.q = q;
    });
  }
  for (const auto field : {&selvage_vertex::u, &selvage_vertex::v}) {
    round_field(field, SELVAGE_SUBTEXELS, candidates);
    move_to_zero(c, field, candidates);
  }
  for (const auto field : {&selvage_vertex::x, &selvage_vertex::y}) {
    round_field(field, SELVAGE_SUBPIXELS, candidates);
  }
  const int64_t left_px = least(c, &selvage_vertex::x) / SELVAGE_SUBPIXELS;
  const int64_t top_px = least(c, &selvage_vertex::y) / SELVAGE_SUBPIXELS;
  candidates.offer([&](Case& moved) { move_outline(moved, -left_px, 0); });
  candidates.offer([&](Case& moved) { move_outline(moved, 0, -top_px); });
}

void simplify_vertex(const Case& c, size_t index, Candidates& candidates) {
  const selvage_vertex& vertex = c.vertices[index];
  const auto offer_field = [&](int32_t selvage_vertex::*field, int32_t value) {
    candidates.offer([&](Case& changed) { changed.vertices[index].*field = value; });
  };
  for (const int64_t nearer : nearer_to_zero(vertex.q - 1)) {
    offer_field(&selvage_vertex::q, static_cast<int32_t>(nearer + 1));
  }
  for (const auto field : {&selvage_vertex::x, &selvage_vertex::y}) {
    for (const int32_t value : rounder(vertex.*field, SELVAGE_SUBPIXELS)) offer_field(field, value);
  }
  for (const auto field : {&selvage_vertex::u, &selvage_vertex::v}) {
    for (const int32_t value : rounder(vertex.*field, SELVAGE_SUBTEXELS)) offer_field(field, value);
  }
}

}  // namespace

std::vector<Case> simpler(const Case& c) {
  Candidates candidates(c);
  drop_vertices(c, candidates);
  shrink_target(c, candidates);
  plain_options(c, candidates);
  shrink_texture(c, candidates);
  shrink_clip(c, candidates);
  simplify_outline(c, candidates);
  for (size_t i = 0; i < c.vertices.size(); ++i) simplify_vertex(c, i, candidates);
  return candidates.take();
}

}  // namespace selvage::spec
