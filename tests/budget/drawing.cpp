#include "drawing.h"

#include <algorithm>
#include <cstdlib>

namespace selvage::budget {
namespace {

constexpr uint32_t kUntouched = 0xFFFFFFFF;
constexpr int32_t kPixelBytes = 4, kPadding_texel = 16;

}  // namespace

Pixels::Pixels(size_t count, uint32_t value) : count_(count) {
  constexpr size_t kPage_bytes = 4096;
  const size_t bytes = count * sizeof(uint32_t);
  first_.reset(
      static_cast<uint32_t*>(std::aligned_alloc(kPage_bytes, bytes + (0 - bytes) % kPage_bytes)));
  std::ranges::fill(get(), value);
}

void Pixels::Free::operator()(uint32_t* memory) const { std::free(memory); }

Texture::Texture(const Work& work)
    : texels_(
          static_cast<size_t>((work.texture_side_texel + kPadding_texel) * work.texture_side_texel),
          0) {
  const int32_t side_texel = work.texture_side_texel, pitch_texel = side_texel + kPadding_texel;
  uint32_t i = 0;
  for (uint32_t& texel : texels_.get()) texel = i++ * 0x9E3779B1u >> 8;
  uint32_t* const texels = texels_.get().data();
  texture_ = {texels,           side_texel,          side_texel, pitch_texel * kPixelBytes,
              SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
  if (work.flips_texture) {
    texture_.texels = texels + pitch_texel * (side_texel - 1);
    texture_.pitch = -texture_.pitch;
  }
  if (work.with_sums) status_ = prepare();
}

selvage_status Texture::prepare() {
  const size_t bytes = selvage_prepare_bytes(&texture_, SELVAGE_LAYOUT_ROWS, 1);
  prepared_.emplace(bytes / sizeof(uint32_t) + 1, 0);
  return selvage_prepare(&texture_, SELVAGE_LAYOUT_ROWS, 1, prepared_->get().data(), bytes,
                         &texture_);
}

Drawing::Drawing(const Work& work, selvage_kernel kernel)
    : work_(work),
      texture_(work),
      pixels_(static_cast<size_t>(work.target_width_px * work.target_height_px), kUntouched),
      target_{pixels_.get().data(), work.target_width_px, work.target_height_px,
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
  return pixels_.get().size() - static_cast<size_t>(std::ranges::count(pixels_.get(), kUntouched));
}

}  // namespace selvage::budget
