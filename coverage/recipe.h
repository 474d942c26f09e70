// The exact profile by recipe: the specification's steps, each of which a wrong mapper may replace.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "coverage/job.h"
#include "spec/exact.h"
#include "spec/filter.h"
#include "spec/subject.h"

namespace selvage::coverage {

[[nodiscard]] inline spec::Rational half() { return {1, 2}; }

// 0 where the polygon does not cover the pixel, which a wrong mapper may draw all the same.
[[nodiscard]] spec::Gradient gradient_at(const std::vector<selvage_vertex>& vertices, int32_t x_px,
                                         int32_t y_px);

struct Recipe {
  // Arguments, as the mapper takes them.
  std::function<void(Job&)> prepare = [](Job&) {};
  // Pixel (x, y) belongs to the clip rectangle.
  std::function<bool(const Job&, int32_t x, int32_t y)> in_clip = coverage::in_clip;
  // The two crossings of a row.
  std::function<std::optional<spec::ScanLine>(const Job&, int32_t y)> cross =
      [](const Job& job, int32_t y) { return spec::scan_line(job.vertices, y); };
  // The pixel's centre lies between them.
  std::function<bool(const spec::ScanLine&, const spec::Rational& x)> covers =
      [](const spec::ScanLine& line, const spec::Rational& x) {
        return line.left.x <= x && x < line.right.x;
      };
  // (u, v) at x, in px; x_L < x_R.
  std::function<spec::Sample(const Job&, const spec::ScanLine&, const spec::Rational& x)> map =
      [](const Job&, const spec::ScanLine& line, const spec::Rational& x) {
        return interpolate(line, x);
      };
  // The same along a row, of a mapper that decides something once a row; empty: `map` is asked.
  using RowMap = std::function<spec::Sample(const spec::Rational& x)>;
  std::function<RowMap(const Job&, const spec::ScanLine&)> map_of_row{};
  // Texel coordinates, before the address mode.
  std::function<int32_t(const spec::Rational&)> round = [](const spec::Rational& u) {
    return spec::floor(u);
  };
  // Along one axis: texel, size, mode.
  std::function<int32_t(int32_t, int32_t, selvage_address)> address = spec::address_texel;
  // Of filters other than nearest: how fast (u, v) changes at a pixel, the box's sides from that,
  // columns or rows and their weights, where these lie in the texture, and the pixel.
  std::function<spec::Gradient(const Job&, int32_t x, int32_t y)> gradient =
      [](const Job& job, int32_t x, int32_t y) { return gradient_at(job.vertices, x, y); };
  std::function<spec::BoxSides(const spec::Gradient&)> sides = spec::box_sides;
  std::function<spec::Taps(selvage_filter, const spec::Rational&, int32_t side_fx8)> taps =
      spec::taps;
  std::function<spec::Taps(const spec::Taps&, int32_t, selvage_address)> address_taps =
      spec::addressed;
  std::function<uint32_t(const spec::Taps& columns, const spec::Taps& rows, const spec::TexelAt&)>
      mean = spec::weighted_mean;
  // The status that the call ends with.
  EndStatus status = [](selvage_status s) { return s; };
  // Whatever else it does when it is done.
  std::function<void(const Job&)> finish = [](const Job&) {};

  [[nodiscard]] static spec::Sample interpolate(const spec::ScanLine& line,
                                                const spec::Rational& x);
};

[[nodiscard]] spec::Subject subject_of(std::string name, Recipe recipe);

}  // namespace selvage::coverage
