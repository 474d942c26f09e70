// Bytes -> the command line's forms of a polygon, a clip, a size and a colour.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "cli/error.h"
#include "cli/polygon_text.h"
#include "cli/raster.h"

namespace {

template <typename Parse>
void try_to(Parse parse) {
  try {
    parse();
  } catch (const selvage::cli::UserError&) {
    // A clear refusal is a right answer; anything else that is thrown ends the program.
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace selvage::cli;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try_to([&] {
    const Job job{{parse_polygon_text(text), {}, {}}};
    if (job[0].vertices.size() < 3) std::abort();
    if (snap(job)[0].size() != job[0].vertices.size()) std::abort();
  });
  try_to([&] { static_cast<void>(parse_clip_text(text)); });
  try_to([&] { static_cast<void>(parse_colour(text)); });
  try_to([&] {
    const Size parsed = parse_size_text(text);
    if (parsed.width_px < 1 || parsed.height_px < 1) std::abort();
  });
  return 0;
}
