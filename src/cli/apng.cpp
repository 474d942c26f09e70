#include "cli/apng.h"

#include <zlib.h>

#include <cmath>
#include <span>
#include <stdexcept>
#include <string_view>

#include "cli/error.h"
#include "cli/png.h"

namespace selvage::cli {
namespace {

using Bytes = std::vector<uint8_t>;

inline constexpr size_t kSignatureBytes = 8, kChunkOverhead_bytes = 12;

void put_16(Bytes& bytes, uint16_t value) {
  bytes.push_back(static_cast<uint8_t>(value >> 8));
  bytes.push_back(static_cast<uint8_t>(value & 0xff));
}
void put_32(Bytes& bytes, uint32_t value) {
  put_16(bytes, static_cast<uint16_t>(value >> 16));
  put_16(bytes, static_cast<uint16_t>(value & 0xffff));
}

[[nodiscard]] uint32_t get_32(std::span<const uint8_t> bytes) {
  return uint32_t{bytes[0]} << 24 | uint32_t{bytes[1]} << 16 | uint32_t{bytes[2]} << 8 | bytes[3];
}

// A chunk is: length of the data, type, data, CRC of type and data.
void put_chunk(Bytes& bytes, std::string_view type, std::span<const uint8_t> data) {
  put_32(bytes, static_cast<uint32_t>(data.size()));
  const size_t start = bytes.size();
  bytes.insert(bytes.end(), type.begin(), type.end());
  bytes.insert(bytes.end(), data.begin(), data.end());
  put_32(bytes, static_cast<uint32_t>(crc32_z(0, bytes.data() + start, type.size() + data.size())));
}

// Calls action(type, data, whole chunk) for each chunk of a PNG that libpng wrote.
template <typename Action>
void for_each_chunk(std::span<const uint8_t> png, Action action) {
  png = png.subspan(kSignatureBytes);
  while (!png.empty()) {
    const size_t data_bytes = get_32(png);
    const std::string_view type(reinterpret_cast<const char*>(png.data()) + 4, 4);
    action(type, png.subspan(8, data_bytes), png.first(data_bytes + kChunkOverhead_bytes));
    png = png.subspan(data_bytes + kChunkOverhead_bytes);
  }
}

}  // namespace

// The convergents of the continued fraction are each nearer than the one before.
FrameDelay frame_delay(double frames_per_s) {
  double rest = 1 / frames_per_s;
  double before[2] = {0, 1}, last[2] = {1, 0};  // numerator, denominator
  for (int i = 0; i < 64; ++i) {
    const double whole = std::floor(rest);
    const double next[2] = {whole * last[0] + before[0], whole * last[1] + before[1]};
    if (!(next[0] <= 65535 && next[1] <= 65535)) break;
    for (const int k : {0, 1}) {
      before[k] = last[k];
      last[k] = next[k];
    }
    // 1 / rate is off by half a unit in the last place; what is left after that is not its own.
    if (std::abs(last[0] / last[1] * frames_per_s - 1) < 0x1p-50) break;
    rest = 1 / (rest - whole);
  }
  if (!(last[0] >= 1 && last[1] >= 1)) {
    throw UserError("an animated PNG shows 1/65535 to 65535 frames a second");
  }
  return {static_cast<uint16_t>(last[0]), static_cast<uint16_t>(last[1])};
}

void Apng::add_control(const Raster& raster) {
  Bytes data;
  put_32(data, sequence_++);
  put_32(data, static_cast<uint32_t>(raster.width_px));
  put_32(data, static_cast<uint32_t>(raster.height_px));
  put_32(data, 0);  // x and y of the frame in the picture
  put_32(data, 0);
  put_16(data, delay_.numerator);
  put_16(data, delay_.denominator);
  data.push_back(0);  // disposal: none
  data.push_back(0);  // blending: the frame replaces what was there
  put_chunk(bytes_, "fcTL", data);
}

// The frame as libpng makes it, taken apart. The first one's chunks are kept but for the end.
void Apng::add(const Raster& raster) {
  if (added_ == frames_) throw std::logic_error("more frames than announced");
  const bool is_first = added_++ == 0;
  if (is_first) {
    width_px_ = raster.width_px;
    height_px_ = raster.height_px;
  }
  if (raster.width_px != width_px_ || raster.height_px != height_px_) {
    throw std::logic_error("frames of two sizes");
  }
  const Bytes png = encode_png(raster);
  if (is_first) bytes_.assign(png.begin(), png.begin() + kSignatureBytes);
  bool has_control = false;
  for_each_chunk(png, [&](std::string_view type, std::span<const uint8_t> data,
                          std::span<const uint8_t> whole) {
    const bool is_data = type == "IDAT";
    if (is_data && !has_control) {
      add_control(raster);
      has_control = true;
    }
    if (is_data && !is_first) {
      Bytes numbered;
      put_32(numbered, sequence_++);
      numbered.insert(numbered.end(), data.begin(), data.end());
      put_chunk(bytes_, "fdAT", numbered);
    } else if (is_first && type != "IEND") {
      bytes_.insert(bytes_.end(), whole.begin(), whole.end());
    }
    if (is_first && type == "IHDR") {
      Bytes animation;
      put_32(animation, frames_);
      put_32(animation, 0);  // plays: without end
      put_chunk(bytes_, "acTL", animation);
    }
  });
}

std::vector<uint8_t> Apng::finish() {
  if (added_ != frames_) throw std::logic_error("fewer frames than announced");
  put_chunk(bytes_, "IEND", {});
  return std::move(bytes_);
}

}  // namespace selvage::cli
