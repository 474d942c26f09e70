#include "cli/png.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <string>

#include "cli/error.h"

namespace selvage::cli {
namespace {

constexpr std::array<uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

// Deflate makes at most 1032 bytes of one, and a byte holds at most 8 pixels.
constexpr int64_t kMaxPixelsPerByte = 8 * 1032;

class Image {
 public:
  Image() { image_.version = PNG_IMAGE_VERSION; }
  ~Image() { png_image_free(&image_); }
  Image(const Image&) = delete;
  Image& operator=(const Image&) = delete;

  png_image* operator->() { return &image_; }
  png_image* get() { return &image_; }

 private:
  png_image image_{};
};

[[nodiscard]] uint32_t big_endian(std::span<const uint8_t> bytes) {
  return uint32_t{bytes[0]} << 24 | uint32_t{bytes[1]} << 16 | uint32_t{bytes[2]} << 8 | bytes[3];
}

// libpng stops reading once it has the last row. A chunk is: length, type, `length` bytes,
// checksum.
void check_reaches_end(std::span<const uint8_t> bytes) {
  bytes = bytes.subspan(kSignature.size());
  while (bytes.size() >= 12) {
    const uint64_t chunk_bytes = uint64_t{big_endian(bytes)} + 12;
    if (chunk_bytes > bytes.size()) break;
    if (std::memcmp(bytes.data() + 4, "IEND", 4) == 0) return;
    bytes = bytes.subspan(static_cast<size_t>(chunk_bytes));
  }
  throw UserError("the PNG is cut short: it has no end chunk");
}

}  // namespace

bool is_png(std::span<const uint8_t> bytes) {
  return bytes.size() >= kSignature.size() &&
         std::equal(kSignature.begin(), kSignature.end(), bytes.begin());
}

Raster decode_png(std::span<const uint8_t> bytes, const SizeLimits& limits) {
  if (!is_png(bytes)) throw UserError("not a PNG: the signature is missing");
  check_reaches_end(bytes);
  Image image;
  if (png_image_begin_read_from_memory(image.get(), bytes.data(), bytes.size()) == 0) {
    throw UserError(std::string("the PNG is damaged: ") + image->message);
  }
  check_size(image->width, image->height, limits);
  if (int64_t{image->width} * image->height >
      static_cast<int64_t>(bytes.size()) * kMaxPixelsPerByte) {
    throw UserError("the PNG is damaged: " + std::to_string(bytes.size()) + " bytes cannot hold " +
                    std::to_string(image->width) + " x " + std::to_string(image->height) + " px");
  }
  image->format = PNG_FORMAT_RGBA;
  image->flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // 16-bit files that name no gamma are sRGB too
  Raster raster{static_cast<int32_t>(image->width), static_cast<int32_t>(image->height), {}};
  raster.rgba.resize(PNG_IMAGE_SIZE(*image.get()));
  if (png_image_finish_read(image.get(), nullptr, raster.rgba.data(), 0, nullptr) == 0) {
    throw UserError(std::string("the PNG is damaged: ") + image->message);
  }
  return raster;
}

std::vector<uint8_t> encode_png(const Raster& raster) {
  Image image;
  image->width = static_cast<png_uint_32>(raster.width_px);
  image->height = static_cast<png_uint_32>(raster.height_px);
  image->format = PNG_FORMAT_RGBA;
  std::vector<uint8_t> bytes(PNG_IMAGE_PNG_SIZE_MAX(*image.get()));
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(image.get(), bytes.data(), &size, 0, raster.rgba.data(), 0,
                                nullptr) == 0) {
    throw std::runtime_error(std::string("cannot encode a PNG: ") + image->message);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace selvage::cli
