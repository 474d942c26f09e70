#include "spec/canvas.h"

#include <cstring>

namespace selvage::spec {
namespace {

inline constexpr size_t kLeastGuardBytes = 64;

[[nodiscard]] size_t word_count(size_t bytes) { return (bytes + 3) / 4; }

}  // namespace

Canvas::Canvas(selvage_format format, int32_t width_px, int32_t height_px, int32_t padding_px,
               bool flip, uint8_t fill)
    : format_(format),
      width_px_(width_px),
      height_px_(height_px),
      flip_(flip),
      fill_(fill),
      bytes_per_pixel_(static_cast<size_t>(bytes_per_pixel(format))),
      row_bytes_(static_cast<size_t>(width_px) * bytes_per_pixel_),
      stride_bytes_(row_bytes_ + static_cast<size_t>(padding_px) * bytes_per_pixel_),
      guard_bytes_(4 * word_count(stride_bytes_ + kLeastGuardBytes)) {
  const size_t bytes = 2 * guard_bytes_ + static_cast<size_t>(height_px) * stride_bytes_;
  storage_.resize(word_count(bytes));
  std::memset(storage_.data(), fill, 4 * storage_.size());
}

ptrdiff_t Canvas::pitch() const {
  const auto stride = static_cast<ptrdiff_t>(stride_bytes_);
  return flip_ ? -stride : stride;
}

size_t Canvas::offset(int32_t x_px, int32_t y_px) const {
  const auto row = static_cast<size_t>(flip_ ? height_px_ - 1 - y_px : y_px);
  return guard_bytes_ + row * stride_bytes_ + static_cast<size_t>(x_px) * bytes_per_pixel_;
}

selvage_image Canvas::image() {
  return {reinterpret_cast<char*>(storage_.data()) + offset(0, 0), width_px_, height_px_, pitch(),
          format_};
}

selvage_texture Canvas::texture() const {
  return {reinterpret_cast<const char*>(storage_.data()) + offset(0, 0),
          width_px_,
          height_px_,
          pitch(),
          format_,
          SELVAGE_LAYOUT_ROWS,
          nullptr};
}

uint32_t Canvas::pixel(int32_t x_px, int32_t y_px) const {
  const char* at = reinterpret_cast<const char*>(storage_.data()) + offset(x_px, y_px);
  if (bytes_per_pixel_ == 1) return static_cast<uint8_t>(*at);
  if (bytes_per_pixel_ == 2) {
    uint16_t value;
    std::memcpy(&value, at, sizeof value);
    return value;
  }
  uint32_t value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

void Canvas::set_pixel(int32_t x_px, int32_t y_px, uint32_t value) {
  char* at = reinterpret_cast<char*>(storage_.data()) + offset(x_px, y_px);
  const auto low8 = static_cast<uint8_t>(value);
  const auto low16 = static_cast<uint16_t>(value);
  if (bytes_per_pixel_ == 1) std::memcpy(at, &low8, sizeof low8);
  if (bytes_per_pixel_ == 2) std::memcpy(at, &low16, sizeof low16);
  if (bytes_per_pixel_ == 4) std::memcpy(at, &value, sizeof value);
}

bool Canvas::guards_are_intact() const {
  const auto* bytes = reinterpret_cast<const uint8_t*>(storage_.data());
  const size_t end = 4 * storage_.size();
  const size_t rows_end = guard_bytes_ + static_cast<size_t>(height_px_) * stride_bytes_;
  for (size_t i = 0; i < end; ++i) {
    const bool in_rows = guard_bytes_ <= i && i < rows_end;
    if (in_rows && (i - guard_bytes_) % stride_bytes_ < row_bytes_) continue;
    if (bytes[i] != fill_) return false;
  }
  return true;
}

}  // namespace selvage::spec
