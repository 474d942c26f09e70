#include "spec/allowed_pixel.h"

#include <algorithm>

#include "spec/canvas.h"
#include "spec/gradient.h"
#include "spec/picture.h"
#include "spec/texel_reach.h"

namespace selvage::spec {
namespace {

inline constexpr int32_t kTexel_fx8 = 256;
inline constexpr uint32_t kMostOfChannel = 255;

[[nodiscard]] uint32_t exact_pixel(const Case& c, Pixel at, const Sample& exact,
                                   const TexelAt& texel_at) {
  const Weights weights = filter_weights(c, at.x_px, at.y_px, exact);
  if (c.filter != SELVAGE_FILTER_NEAREST) {
    return weighted_mean(weights.columns, weights.rows, texel_at);
  }
  const Texel texel{weights.columns.front().texel, weights.rows.front().texel};
  return texel_at(texel) & value_bits(c.format);
}

// Where the filters' formulas may be greatest, from one end of a reach to the other.
[[nodiscard]] std::vector<Rational> turning_points(const Rational& exact,
                                                   const Rational& accuracy) {
  const Rational half(1, 2);
  const int32_t first_fx8 = floor(kTexel_fx8 * (exact - accuracy - half));
  const int32_t last_fx8 = floor(kTexel_fx8 * (exact + accuracy - half));
  std::vector<Rational> points;
  const auto add = [&](int32_t fx8) { points.push_back(Rational(fx8) / kTexel_fx8 + half); };
  add(first_fx8);
  for (int32_t texel = (first_fx8 >> 8) + 1; texel * kTexel_fx8 <= last_fx8; ++texel) {
    add(texel * kTexel_fx8);
  }
  add(last_fx8);
  return points;
}

// How far off |du/dx| + |du/dy| may be, in texels a pixel, where u is off by a texel at most: by
// as much as vertices off by a texel make of it, which is the more the narrower the polygon, and by
// what four values next to each other do.
[[nodiscard]] Rational steepness_of_error(const Case& c, Pixel at) {
  constexpr int kNeighbours = 4;
  Rational most = kNeighbours;
  std::vector<selvage_vertex> lifted = c.vertices;
  for (selvage_vertex& v : lifted) v.u = 0;
  for (selvage_vertex& v : lifted) {
    v.u = SELVAGE_SUBTEXELS;
    const Gradient g = gradient(lifted, at.x_px, at.y_px).value();
    most += abs(g.u_along_x) + abs(g.u_along_y);
    v.u = 0;
  }
  return most;
}

// What share of a box of such a side another one may leave out that is as large or larger, where it
// is moved by `accuracy` at most and its side differs by `grown`, in texels.
[[nodiscard]] Rational share_apart(int32_t side_fx8, const Rational& accuracy,
                                   const Rational& grown) {
  const Rational moved_fx8 = kTexel_fx8 * accuracy + 2, grown_fx8 = kTexel_fx8 * grown + 2;
  return std::min<Rational>((moved_fx8 + grown_fx8) / side_fx8, 1);  // both in whole steps
}

}  // namespace

AllowedPixel::AllowedPixel(const Case& c, Pixel at, const Sample& exact, const TexelAt& texel_at,
                           const Rational& accuracy)
    : exact_(exact_pixel(c, at, exact, texel_at)) {
  if (c.filter == SELVAGE_FILTER_NEAREST) {
    take_texels(c, exact, texel_at, accuracy);
  } else if (c.filter == SELVAGE_FILTER_AREA) {
    take_boxes(c, at, accuracy);
  } else {
    take_means(c, exact, texel_at, accuracy);
  }
}

void AllowedPixel::take_texels(const Case& c, const Sample& exact, const TexelAt& texel_at,
                               const Rational& accuracy) {
  const auto range = [&](const Rational& u, int32_t size) {
    return TexelRange{floor(u - accuracy), floor(u + accuracy), size, c.address};
  };
  const TexelRange columns = range(exact.u, c.texture_width_texel);
  const TexelRange rows = range(exact.v, c.texture_height_texel);
  for (int32_t t = rows.first; t <= rows.last; ++t) {
    for (int32_t s = columns.first; s <= columns.last; ++s) {
      const Texel texel{address_texel(s, columns.size, c.address),
                        address_texel(t, rows.size, c.address)};
      texels_.push_back(texel_at(texel) & value_bits(c.format));
    }
  }
  texels_text_ = "one of the texels in columns " + columns.text() + ", rows " + rows.text();
}

void AllowedPixel::take_means(const Case& c, const Sample& exact, const TexelAt& texel_at,
                              const Rational& accuracy) {
  least_.fill(kMostOfChannel);
  for (const Rational& v : turning_points(exact.v, accuracy)) {
    const Taps rows =
        addressed(taps(c.filter, v, kLeastBoxSide_fx8), c.texture_height_texel, c.address);
    for (const Rational& u : turning_points(exact.u, accuracy)) {
      const Taps columns =
          addressed(taps(c.filter, u, kLeastBoxSide_fx8), c.texture_width_texel, c.address);
      const uint32_t mean = weighted_mean(columns, rows, texel_at);
      for (size_t i = 0; i < least_.size(); ++i) {
        least_[i] = std::min(least_[i], channel(mean, static_cast<int>(i)));
        greatest_[i] = std::max(greatest_[i], channel(mean, static_cast<int>(i)));
      }
    }
  }
}

void AllowedPixel::take_boxes(const Case& c, Pixel at, const Rational& accuracy) {
  const BoxSides sides = box_sides(gradient(c.vertices, at.x_px, at.y_px).value());
  const Rational grown = accuracy * steepness_of_error(c, at);
  const Rational apart = kMostOfChannel * (share_apart(sides.u_fx8, accuracy, grown) +
                                           share_apart(sides.v_fx8, accuracy, grown));
  const auto most = static_cast<uint32_t>(floor(apart)) + 1;  // rounded, both of them
  for (size_t i = 0; i < least_.size(); ++i) {
    const uint32_t value = channel(exact_, static_cast<int>(i));
    least_[i] = value - std::min(value, most);
    greatest_[i] = std::min(value + most, kMostOfChannel);
  }
}

bool AllowedPixel::holds(uint32_t value) const {
  if (!texels_.empty()) return std::ranges::find(texels_, value) != texels_.end();
  for (size_t i = 0; i < least_.size(); ++i) {
    const uint32_t told = channel(value, static_cast<int>(i));
    if (told < least_[i] || told > greatest_[i]) return false;
  }
  return true;
}

std::string AllowedPixel::text() const {
  if (!texels_.empty()) return texels_text_;
  std::string text = "channels";
  for (size_t i = 0; i < least_.size(); ++i) {
    text += (i == 0 ? " " : ", ") + std::to_string(least_[i]);
    if (greatest_[i] != least_[i]) text += " .. " + std::to_string(greatest_[i]);
  }
  return text;
}

}  // namespace selvage::spec
