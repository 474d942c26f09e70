// Bytes -> the PNG reader. What it accepts must survive being written and read again.
#include <cstdint>
#include <cstdlib>

#include "cli/error.h"
#include "cli/png.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace selvage::cli;
  const SizeLimits limits{2048, 1 << 20};  // larger pictures would only run slower
  try {
    const Raster picture = decode_png({data, size}, limits);
    if (decode_png(encode_png(picture), limits) != picture) std::abort();
  } catch (const UserError&) {
    // A clear refusal is a right answer; anything else that is thrown ends the program.
  }
  return 0;
}
