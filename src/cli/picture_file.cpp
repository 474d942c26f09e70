#include "cli/picture_file.h"

#include "cli/error.h"
#include "cli/file.h"
#include "cli/jpeg.h"
#include "cli/png.h"

namespace selvage::cli {

Raster decode_picture(std::span<const uint8_t> bytes, const SizeLimits& limits) {
  if (bytes.empty()) throw UserError("the file is empty; a PNG or a JPEG picture is needed");
  if (is_png(bytes)) return decode_png(bytes, limits);
  if (is_jpeg(bytes)) return decode_jpeg(bytes, limits);
  throw UserError("neither a PNG nor a JPEG picture");
}

Raster read_picture(const std::filesystem::path& path) {
  const std::vector<uint8_t> bytes = read_file(path);
  return about("'" + path.string() + "'", [&] { return decode_picture(bytes); });
}

}  // namespace selvage::cli
