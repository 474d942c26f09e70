#include "sample_pictures.h"

#include <png.h>
#include <turbojpeg.h>
#include <zlib.h>

#include <cstring>
#include <stdexcept>

namespace selvage::cli::test {
namespace {

[[nodiscard]] uint8_t byte(int32_t value) { return static_cast<uint8_t>(value & 255); }

void put_big_endian(uint8_t* at, uint32_t value) {
  for (int i = 0; i < 4; ++i) at[i] = static_cast<uint8_t>(value >> (24 - 8 * i));
}

void append(png_structp png, png_bytep data, png_size_t size) {
  auto& bytes = *static_cast<std::vector<uint8_t>*>(png_get_io_ptr(png));
  bytes.insert(bytes.end(), data, data + size);
}

void set_palette(png_structp png, png_infop info, int entries) {
  std::vector<png_color> palette;
  std::vector<png_byte> alpha;
  for (int i = 0; i < entries; ++i) {
    palette.push_back({byte(40 * i), byte(255 - 9 * i), byte(17 * i)});
    alpha.push_back(byte(255 - i));
  }
  png_set_PLTE(png, info, palette.data(), entries);
  png_set_tRNS(png, info, alpha.data(), entries, nullptr);
}

}  // namespace

Raster sample_raster(int32_t width_px, int32_t height_px, bool opaque) {
  Raster raster = filled(width_px, height_px, {});
  for (int32_t y = 0; y < height_px; ++y) {
    for (int32_t x = 0; x < width_px; ++x) {
      const uint8_t alpha = opaque ? uint8_t{255} : byte(255 - 3 * x - y);
      raster.set(x, y, {byte(37 * x + 11 * y), byte(91 * y + 5 * x), byte(x * y + 60), alpha});
    }
  }
  return raster;
}

Raster smooth_raster(int32_t width_px, int32_t height_px) {
  Raster raster = filled(width_px, height_px, {});
  for (int32_t y = 0; y < height_px; ++y) {
    for (int32_t x = 0; x < width_px; ++x) {
      raster.set(x, y, {byte(40 + 2 * x), byte(200 - 2 * y), byte(90 + x + y)});
    }
  }
  return raster;
}

std::vector<uint8_t> sample_png(const PngKind& kind) {
  constexpr png_uint_32 kWidth = 9;
  constexpr png_uint_32 kHeight = 7;
  std::vector<uint8_t> bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  if (setjmp(png_jmpbuf(png)) != 0) throw std::runtime_error("libpng cannot write the sample");
  png_set_write_fn(png, &bytes, append, nullptr);
  png_set_IHDR(png, info, kWidth, kHeight, kind.bit_depth, kind.colour_type,
               kind.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (kind.colour_type == PNG_COLOR_TYPE_PALETTE) set_palette(png, info, 1 << kind.bit_depth);
  png_write_info(png, info);
  const size_t row_bytes = png_get_rowbytes(png, info);
  std::vector<uint8_t> pixels(row_bytes * kHeight);
  for (size_t i = 0; i < pixels.size(); ++i) pixels[i] = byte(static_cast<int32_t>(73 * i + 5));
  std::vector<png_bytep> rows;
  for (size_t y = 0; y < kHeight; ++y) rows.push_back(pixels.data() + y * row_bytes);
  png_write_image(png, rows.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

// Signature 8, then IHDR: length 4, type 4, width 4, height 4, 5 more, checksum of type and data.
std::vector<uint8_t> with_png_size(std::vector<uint8_t> png, uint32_t width_px,
                                   uint32_t height_px) {
  put_big_endian(png.data() + 16, width_px);
  put_big_endian(png.data() + 20, height_px);
  put_big_endian(png.data() + 29,
                 static_cast<uint32_t>(crc32(crc32(0, nullptr, 0), png.data() + 12, 17)));
  return png;
}

std::vector<uint8_t> encode_jpeg(const Raster& raster, JpegKind kind) {
  tjhandle compressor = tjInitCompress();
  unsigned char* out = nullptr;
  unsigned long size = 0;
  const int format = kind == JpegKind::kCmyk ? TJPF_CMYK : TJPF_RGBA;
  const int samples = kind == JpegKind::kGrey ? TJSAMP_GRAY : TJSAMP_420;
  const int flags = kind == JpegKind::kProgressive ? TJFLAG_PROGRESSIVE : 0;
  const int failed = tjCompress2(compressor, raster.rgba.data(), raster.width_px, 0,
                                 raster.height_px, format, &out, &size, samples, 95, flags);
  std::vector<uint8_t> bytes;
  if (failed == 0) bytes.assign(out, out + size);
  tjFree(out);
  tjDestroy(compressor);
  if (failed != 0) throw std::runtime_error("TurboJPEG cannot write the sample");
  return bytes;
}

// A segment is: ff, marker, length 2 (itself included), data. SOF0 .. SOF2 hold: precision 1,
// height 2, width 2.
std::vector<uint8_t> with_jpeg_size(std::vector<uint8_t> jpeg, uint16_t width_px,
                                    uint16_t height_px) {
  for (size_t at = 2; at + 9 < jpeg.size();) {
    if (jpeg[at + 1] >= 0xc0 && jpeg[at + 1] <= 0xc2) {
      jpeg[at + 5] = static_cast<uint8_t>(height_px >> 8);
      jpeg[at + 6] = static_cast<uint8_t>(height_px & 255);
      jpeg[at + 7] = static_cast<uint8_t>(width_px >> 8);
      jpeg[at + 8] = static_cast<uint8_t>(width_px & 255);
      return jpeg;
    }
    at += 2 + (size_t{jpeg[at + 2]} << 8 | jpeg[at + 3]);
  }
  throw std::runtime_error("the sample has no frame header");
}

}  // namespace selvage::cli::test
