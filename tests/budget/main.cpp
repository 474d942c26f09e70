// Draws a stated workload a stated number of times: what tests/budget/run counts instructions of.
#include <charconv>
#include <cstdio>
#include <cstring>
#include <string_view>

#include "work.h"

namespace selvage::budget {
namespace {

enum Exit { kFine = 0, kFailed = 1, kWrongUse = 2, kNotHere = 3 };

constexpr const char* kUsage =
    "Usage: selvage_work KIND PASSES KERNEL\n"
    "       selvage_work --build\n\n"
    "Draws KIND (mesh-52, mesh-484, tilted-52, tilted-484, affine, perspective, bilinear,\n"
    "bilinear-any) PASSES times with KERNEL (scalar, sse4, avx2) and prints what a pass draws:\n"
    "UNITS UNIT PIXELS. With --build, prints the compiler and the kind of build.\n\n"
    "Example: selvage_work mesh-52 2 scalar\n\n"
    "Exit status: 0 drawn, 1 refused by the mapper, 2 wrong use, 3 no such kernel here.\n";

constexpr uint32_t kUntouched = 0xFFFFFFFF;

std::optional<selvage_kernel> kernel_of(std::string_view name) {
  if (name == "scalar") return SELVAGE_KERNEL_SCALAR;
  if (name == "sse4") return SELVAGE_KERNEL_SSE4;
  if (name == "avx2") return SELVAGE_KERNEL_AVX2;
  return std::nullopt;
}

std::optional<int> number_of(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 1) return std::nullopt;
  return number;
}

// Padded, as the benchmark's textures are.
std::vector<uint32_t> texels(int32_t pitch_texel) {
  std::vector<uint32_t> all(static_cast<size_t>(pitch_texel * kTextureSide_texel));
  for (size_t i = 0; i < all.size(); ++i) all[i] = static_cast<uint32_t>(i) * 0x9E3779B1u >> 8;
  return all;
}

int draw(const Work& work, int passes, selvage_kernel kernel) {
  constexpr int32_t pitch_texel = kTextureSide_texel + 16, pixel_bytes = 4;
  const std::vector<uint32_t> source = texels(pitch_texel);
  const selvage_texture texture{source.data(),
                                kTextureSide_texel,
                                kTextureSide_texel,
                                pitch_texel * pixel_bytes,
                                SELVAGE_RGBA8888,
                                SELVAGE_LAYOUT_ROWS,
                                nullptr};
  std::vector<uint32_t> pixels(static_cast<size_t>(kTargetWidth_px * work.target_height_px),
                               kUntouched);
  const selvage_image target{pixels.data(), kTargetWidth_px, work.target_height_px,
                             kTargetWidth_px * pixel_bytes, SELVAGE_RGBA8888};
  selvage_options options{};
  options.filter = work.filter;
  options.kernel = kernel;
  for (int pass = 0; pass < passes; ++pass) {
    for (const Triangle& triangle : work.triangles) {
      const selvage_status status =
          selvage_draw(&target, nullptr, triangle.data(), triangle.size(), &texture, &options);
      if (status != SELVAGE_OK) {
        std::fprintf(stderr, "selvage_work: %s\n", selvage_status_text(status));
        return kFailed;
      }
    }
  }
  size_t drawn_px = 0;
  for (const uint32_t pixel : pixels) drawn_px += pixel != kUntouched;
  const size_t units = work.unit == "px" ? drawn_px : work.triangles.size();
  std::printf("%zu %.*s %zu\n", units, static_cast<int>(work.unit.size()), work.unit.data(),
              drawn_px);
  return kFine;
}

int run(int count, char** arguments) {
  if (count == 2 && std::strcmp(arguments[1], "--build") == 0) {
    std::puts(SELVAGE_BUDGET_BUILD);
    return kFine;
  }
  const auto work = count == 4 ? work_of(arguments[1]) : std::nullopt;
  const auto passes = count == 4 ? number_of(arguments[2]) : std::nullopt;
  const auto kernel = count == 4 ? kernel_of(arguments[3]) : std::nullopt;
  if (!work || !passes || !kernel) {
    std::fputs(kUsage, count == 2 && std::strcmp(arguments[1], "--help") == 0 ? stdout : stderr);
    return count == 2 && std::strcmp(arguments[1], "--help") == 0 ? kFine : kWrongUse;
  }
  if (selvage_has_kernel(*kernel) == 0) return kNotHere;
  return draw(*work, *passes, *kernel);
}

}  // namespace
}  // namespace selvage::budget

int main(int count, char** arguments) { return selvage::budget::run(count, arguments); }
