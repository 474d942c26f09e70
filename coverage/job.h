// What recipes draw with: the arguments of a call, checked, and a subject made of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "spec/exact.h"
#include "spec/subject.h"

namespace selvage::coverage {

[[nodiscard]] ptrdiff_t bytes_per_texel(selvage_format format);
// As the layout says.
[[nodiscard]] ptrdiff_t place_of(const selvage_texture& texture, spec::Texel texel);

// The arguments of a draw call that has passed every check.
struct Job {
  selvage_image target;
  selvage_rect clip;  // the whole target where there was none
  std::vector<selvage_vertex> vertices;
  selvage_texture texture;
  selvage_address address;
  selvage_filter filter;
  int32_t tolerance;  // 1/65536 texel
  // The bytes from the texture's first texel to one.
  std::function<ptrdiff_t(const selvage_texture&, spec::Texel)> place = place_of;
};

// Pixel (x, y) belongs to the clip rectangle.
[[nodiscard]] bool in_clip(const Job& job, int32_t x, int32_t y);

// Pixel (x, y) becomes the texel, which has been addressed.
void copy_texel(const Job& job, spec::Texel texel, int32_t x, int32_t y);

// The value of a texel that has been addressed, and what pixel (x, y) becomes: RGBA8888.
[[nodiscard]] uint32_t texel_value(const Job& job, spec::Texel texel);
void set_pixel(const Job& job, uint32_t value, int32_t x, int32_t y);

using DrawJob = std::function<void(Job)>;
// The status that a call ends with, from the one that its checks gave.
using EndStatus = std::function<selvage_status(selvage_status)>;

// Checks its arguments as selvage does, then draws so.
[[nodiscard]] spec::Subject subject_of(std::string name, selvage_profile profile, DrawJob draw,
                                       EndStatus status);

}  // namespace selvage::coverage
