#include "drawing.h"

#include <algorithm>
#include <cstdlib>

namespace selvage::budget {
namespace {

constexpr uint32_t kUntouched = 0xFFFFFFFF;
constexpr int32_t kPixelBytes = 4;

}  // namespace

Texture::Texture(const Work& work) {
  const int32_t side_texel = work.texture_side_texel, pitch_texel = side_texel + 16;
  texels_.resize(static_cast<size_t>(pitch_texel * side_texel));
  for (size_t i = 0; i < texels_.size(); ++i) {
    texels_[i] = static_cast<uint32_t>(i) * 0x9E3779B1u >> 8;
  }
  texture_ = {texels_.data(),   side_texel,          side_texel, pitch_texel * kPixelBytes,
              SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
  if (work.flips_texture) {
    texture_.texels = texels_.data() + pitch_texel * (side_texel - 1);
    texture_.pitch = -texture_.pitch;
  }
  if (work.with_sums) status_ = prepare();
}

selvage_status Texture::prepare() {
  const size_t bytes = selvage_prepare_bytes(&texture_, SELVAGE_LAYOUT_ROWS, 1);
  prepared_.reset(static_cast<char*>(std::aligned_alloc(
      SELVAGE_PREPARED_ALIGNMENT, bytes + (0 - bytes) % SELVAGE_PREPARED_ALIGNMENT)));
  return selvage_prepare(&texture_, SELVAGE_LAYOUT_ROWS, 1, prepared_.get(), bytes, &texture_);
}

void Texture::Free::operator()(char* memory) const { std::free(memory); }

Drawing::Drawing(const Work& work, selvage_kernel kernel)
    : work_(work),
      texture_(work),
      pixels_(static_cast<size_t>(work.target_width_px * work.target_height_px), kUntouched),
      target_{pixels_.data(), work.target_width_px, work.target_height_px,
              work.target_width_px * kPixelBytes, SELVAGE_RGBA8888} {
  options_.filter = work.filter;
  options_.address = work.address;
  options_.kernel = kernel;
  if (!work.as_list) return;
  for (const Polygon& each : work.polygons) {
    list_.push_back({each.data(), each.size(), &texture_.get()});
  }
  scratch_.resize(selvage_draw_many_bytes(list_.size()) / sizeof(std::max_align_t) + 1);
}

selvage_status Drawing::draw() {
  if (texture_.status() != SELVAGE_OK) return texture_.status();
  const selvage_rect rows{0, work_.rows_px.begin, work_.target_width_px, work_.rows_px.end};
  if (work_.as_list) {
    return selvage_draw_many(&target_, &rows, list_.data(), list_.size(), &options_, 1,
                             scratch_.data(), scratch_.size() * sizeof(std::max_align_t), nullptr);
  }
  for (const Polygon& each : work_.polygons) {
    const selvage_status status =
        selvage_draw(&target_, &rows, each.data(), each.size(), &texture_.get(), &options_);
    if (status != SELVAGE_OK) return status;
  }
  return SELVAGE_OK;
}

size_t Drawing::units() const {
  if (work_.unit == "triangle") return work_.polygons.size();
  return pixels_.size() - static_cast<size_t>(std::ranges::count(pixels_, kUntouched));
}

}  // namespace selvage::budget
