// Bytes -> the PNG reader, as they are and with every checksum made right, so that the fuzzer need
// not guess them. What the reader accepts must survive being written and read again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "cli/error.h"
#include "cli/png.h"

namespace {

using namespace selvage::cli;

// CRC-32 of ISO 3309, bit by bit.
[[nodiscard]] uint32_t checksum(std::span<const uint8_t> bytes) {
  uint32_t crc = ~uint32_t{0};
  for (const uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0xedb88320U : 0);
  }
  return ~crc;
}

// A signature of 8 bytes, then chunks: length 4, type 4, `length` bytes, checksum of all but
// length.
[[nodiscard]] std::vector<uint8_t> with_right_checksums(std::vector<uint8_t> png) {
  for (size_t at = 8; at + 12 <= png.size();) {
    const uint32_t length = uint32_t{png[at]} << 24 | uint32_t{png[at + 1]} << 16 |
                            uint32_t{png[at + 2]} << 8 | png[at + 3];
    if (length > png.size() - at - 12) break;
    const uint32_t crc = checksum(std::span(png).subspan(at + 4, size_t{length} + 4));
    at += size_t{length} + 12;
    for (size_t i = 0; i < 4; ++i) png[at - 4 + i] = static_cast<uint8_t>(crc >> (24 - 8 * i));
  }
  return png;
}

void read(std::span<const uint8_t> bytes) {
  const SizeLimits limits{2048, 1 << 18};  // larger pictures would only run slower
  try {
    const Raster picture = decode_png(bytes, limits);
    if (decode_png(encode_png(picture), limits) != picture) std::abort();
  } catch (const UserError&) {
    // A clear refusal is a right answer; anything else that is thrown ends the program.
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  read({data, size});
  read(with_right_checksums({data, data + size}));
  return 0;
}
