#include "cli/jpeg.h"

#include <turbojpeg.h>

#include <memory>
#include <new>
#include <string>

#include "cli/error.h"

namespace selvage::cli {
namespace {

struct Destroy {
  void operator()(void* handle) const { tjDestroy(handle); }
};
using Decompressor = std::unique_ptr<void, Destroy>;

[[nodiscard]] UserError damaged(const Decompressor& decompressor) {
  return UserError(std::string("the JPEG is cut short or damaged: ") +
                   tjGetErrorStr2(decompressor.get()));
}

}  // namespace

bool is_jpeg(std::span<const uint8_t> bytes) {
  return bytes.size() >= 3 && bytes[0] == 0xff && bytes[1] == 0xd8 && bytes[2] == 0xff;
}

Raster decode_jpeg(std::span<const uint8_t> bytes, const SizeLimits& limits) {
  if (!is_jpeg(bytes)) throw UserError("not a JPEG: the signature is missing");
  const Decompressor decompressor(tjInitDecompress());
  if (!decompressor) throw std::bad_alloc();
  int width = 0;
  int height = 0;
  int subsampling = 0;
  int colours = 0;
  if (tjDecompressHeader3(decompressor.get(), bytes.data(), bytes.size(), &width, &height,
                          &subsampling, &colours) != 0) {
    throw damaged(decompressor);
  }
  if (width == 0 && height == 0) {
    throw UserError("the JPEG is cut short or damaged: it ends before its size");
  }
  check_size(width, height, limits);
  if (colours == TJCS_CMYK || colours == TJCS_YCCK) {
    throw UserError("the JPEG is in CMYK; a grey or an RGB one is needed");
  }
  Raster raster = filled(width, height, {});
  // Stopping on a warning refuses files that are cut short. The limit on scans bounds the time a
  // progressive file can take.
  const int flags = TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS | TJFLAG_ACCURATEDCT;
  if (tjDecompress2(decompressor.get(), bytes.data(), bytes.size(), raster.rgba.data(), width, 0,
                    height, TJPF_RGBA, flags) != 0) {
    throw damaged(decompressor);
  }
  return raster;
}

}  // namespace selvage::cli
