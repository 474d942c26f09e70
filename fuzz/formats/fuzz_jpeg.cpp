// Bytes -> the JPEG reader. What it accepts must be whole and within the limits.
#include <cstdint>
#include <cstdlib>

#include "cli/error.h"
#include "cli/jpeg.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace selvage::cli;
  const SizeLimits limits{2048, 1 << 18};  // larger pictures would only run slower
  try {
    const Raster picture = decode_jpeg({data, size}, limits);
    const int64_t area_px = int64_t{picture.width_px} * picture.height_px;
    if (area_px < 1 || area_px > limits.area_px) std::abort();
    if (picture.rgba.size() != 4 * static_cast<size_t>(area_px)) std::abort();
  } catch (const UserError&) {
    // A clear refusal is a right answer; anything else that is thrown ends the program.
  }
  return 0;
}
