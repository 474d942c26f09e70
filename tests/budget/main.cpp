// Draws a stated workload a stated number of times: what tests/budget/run counts instructions of.
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string_view>

#include "work.h"

namespace selvage::budget {
namespace {

enum Exit { kFine = 0, kFailed = 1, kWrongUse = 2, kNotHere = 3 };

constexpr const char* kUsage =
    "Usage: selvage_work KIND PASSES KERNEL\n"
    "       selvage_work --build\n\n"
    "Draws KIND (mesh-52, mesh-484, tilted-52, tilted-484, affine, perspective, bilinear,\n"
    "bilinear-any, area, area-tilted, area-ruled, area-sums, quads, quad-tilted; an adversarial "
    "item\n"
    "of the report, A1 to A14, or its twin, A1-ordinary to A14-ordinary) PASSES times with KERNEL\n"
    "(scalar, sse4, avx2) and prints what a pass draws: UNITS UNIT PIXELS. With --build, prints "
    "the compiler and\n"
    "the kind of build.\n\n"
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

constexpr int32_t kPixelBytes = 4;

// Padded, as the benchmark's textures are; with sums if the work wants them.
class Texture {
 public:
  explicit Texture(const Work& work) {
    const int32_t side_texel = work.texture_side_texel, pitch_texel = side_texel + 16;
    texels_.resize(static_cast<size_t>(pitch_texel * side_texel));
    for (size_t i = 0; i < texels_.size(); ++i) {
      texels_[i] = static_cast<uint32_t>(i) * 0x9E3779B1u >> 8;
    }
    texture_ = {texels_.data(),   side_texel,          side_texel, pitch_texel * kPixelBytes,
                SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
    if (work.with_sums) status_ = prepare();
  }
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

  [[nodiscard]] selvage_status status() const { return status_; }
  [[nodiscard]] const selvage_texture& get() const { return texture_; }

 private:
  [[nodiscard]] selvage_status prepare() {
    const size_t bytes = selvage_prepare_bytes(&texture_, SELVAGE_LAYOUT_ROWS, 1);
    prepared_.reset(static_cast<char*>(std::aligned_alloc(
        SELVAGE_PREPARED_ALIGNMENT, bytes + (0 - bytes) % SELVAGE_PREPARED_ALIGNMENT)));
    return selvage_prepare(&texture_, SELVAGE_LAYOUT_ROWS, 1, prepared_.get(), bytes, &texture_);
  }
  struct Free {
    void operator()(char* memory) const { std::free(memory); }
  };

  std::vector<uint32_t> texels_;
  std::unique_ptr<char, Free> prepared_;
  selvage_texture texture_{};
  selvage_status status_ = SELVAGE_OK;
};

int failed(selvage_status status) {
  std::fprintf(stderr, "selvage_work: %s\n", selvage_status_text(status));
  return kFailed;
}

int draw(const Work& work, int passes, selvage_kernel kernel) {
  const Texture texture(work);
  if (texture.status() != SELVAGE_OK) return failed(texture.status());
  std::vector<uint32_t> pixels(static_cast<size_t>(work.target_width_px * work.target_height_px),
                               kUntouched);
  const selvage_image target{pixels.data(), work.target_width_px, work.target_height_px,
                             work.target_width_px * kPixelBytes, SELVAGE_RGBA8888};
  selvage_options options{};
  options.filter = work.filter;
  options.kernel = kernel;
  for (int pass = 0; pass < passes; ++pass) {
    for (const Polygon& polygon : work.polygons) {
      const selvage_status status =
          selvage_draw(&target, nullptr, polygon.data(), polygon.size(), &texture.get(), &options);
      if (status != SELVAGE_OK) return failed(status);
    }
  }
  size_t drawn_px = 0;
  for (const uint32_t pixel : pixels) drawn_px += pixel != kUntouched;
  const size_t units = work.unit == "px" ? drawn_px : work.polygons.size();
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
