// What a pixel may be, of a mapper whose u and v are off by so much at most: with nearest a texel
// of a few, with the other filters a mean of the texels around.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "spec/case.h"
#include "spec/exact.h"
#include "spec/filter.h"
#include "spec/geometry.h"

namespace selvage::spec {

class AllowedPixel {
 public:
  // At a pixel that the valid case covers, for its exact coordinates there. `accuracy` in texels,
  // below 1.
  AllowedPixel(const Case& c, Pixel at, const Sample& exact, const TexelAt& texel_at,
               const Rational& accuracy);

  [[nodiscard]] bool holds(uint32_t value) const;
  // What it is where nothing is off.
  [[nodiscard]] uint32_t exact() const { return exact_; }
  // "one of the texels in columns 3 .. 4, rows 7 .. 7", or "channels 0 .. 3, 17 .. 20, ...".
  [[nodiscard]] std::string text() const;

 private:
  using Channels = std::array<uint32_t, 4>;

  void take_texels(const Case& c, const Sample& exact, const TexelAt& texel_at,
                   const Rational& accuracy);
  // Of filters four and bilinear: their formulas, between the steps of 1/256 texel, are linear in u
  // and in v where no texel's centre lies between, and so are greatest at the ends and there.
  void take_means(const Case& c, const Sample& exact, const TexelAt& texel_at,
                  const Rational& accuracy);
  // Of the area filter, whose box may be as far off, and its sides by what that makes of the
  // derivatives: two boxes have means that differ by no more than the greatest texel, times the
  // share that they do not share.
  void take_boxes(const Case& c, Pixel at, const Rational& accuracy);

  uint32_t exact_;
  std::vector<uint32_t> texels_{};  // of nearest
  std::string texels_text_{};
  Channels least_{}, greatest_{};  // of the others
};

}  // namespace selvage::spec
