// Draws stated workloads, each once unseen and once for valgrind's callgrind to count: what
// tests/budget/run runs.
#include <valgrind/callgrind.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "work.h"

namespace selvage::budget {
namespace {

enum Exit { kFine = 0, kFailed = 1, kWrongUse = 2, kNotHere = 3 };

constexpr const char* kUsage =
    "Usage: selvage_work KERNEL KIND...\n"
    "       selvage_work --build\n\n"
    "Draws each KIND (mesh-52, mesh-484, tilted-52, tilted-484, affine, perspective, bilinear,\n"
    "bilinear-any, area, area-tilted, area-ruled, area-sums, quads, quad-tilted; an adversarial\n"
    "item of the report, A1 to A14, or its twin, A1-ordinary to A14-ordinary; a map of\n"
    "`selvage bench --near-ties`, seed-N, or a twin of it, seed-N-ordinary; any of these with\n"
    "-flipped behind it, from a texture stored bottom row first, or -list, by one call) twice\n"
    "with KERNEL (scalar, sse4, avx2). Under valgrind's callgrind with --instr-atstart=no the\n"
    "second drawing alone is counted, and dumped under the KIND's name. After each, prints what\n"
    "was drawn: KIND UNITS UNIT.\n"
    "With --build, prints the compiler and the kind of build.\n\n"
    "Example: selvage_work scalar mesh-52 A1\n\n"
    "Exit status: 0 drawn, 1 refused by the mapper, 2 wrong use, 3 no such kernel here.\n";

constexpr uint32_t kUntouched = 0xFFFFFFFF;

std::optional<selvage_kernel> kernel_of(std::string_view name) {
  if (name == "scalar") return SELVAGE_KERNEL_SCALAR;
  if (name == "sse4") return SELVAGE_KERNEL_SSE4;
  if (name == "avx2") return SELVAGE_KERNEL_AVX2;
  return std::nullopt;
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
    if (work.flips_texture) {
      texture_.texels = texels_.data() + pitch_texel * (side_texel - 1);
      texture_.pitch = -texture_.pitch;
    }
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

// A drawing of a work, to be done more than once.
class Drawing {
 public:
  Drawing(const Work& work, const selvage_image& target, const selvage_texture& texture,
          const selvage_options& options)
      : work_(work), target_(target), texture_(texture), options_(options) {
    if (!work.as_list) return;
    for (const Polygon& each : work.polygons) {
      list_.push_back({each.data(), each.size(), &texture});
    }
    scratch_.resize(selvage_draw_many_bytes(list_.size()) / sizeof(std::max_align_t) + 1);
  }

  [[nodiscard]] selvage_status draw() {
    if (work_.as_list) {
      return selvage_draw_many(&target_, nullptr, list_.data(), list_.size(), &options_, 1,
                               scratch_.data(), scratch_.size() * sizeof(std::max_align_t),
                               nullptr);
    }
    for (const Polygon& each : work_.polygons) {
      const selvage_status status =
          selvage_draw(&target_, nullptr, each.data(), each.size(), &texture_, &options_);
      if (status != SELVAGE_OK) return status;
    }
    return SELVAGE_OK;
  }

 private:
  const Work& work_;
  const selvage_image& target_;
  const selvage_texture& texture_;
  const selvage_options& options_;
  std::vector<selvage_polygon> list_;
  std::vector<std::max_align_t> scratch_;
};

// What a first drawing alone does, such as finding out what the machine has, is not counted.
int draw_and_count(const char* kind, const Work& work, selvage_kernel kernel) {
  const Texture texture(work);
  if (texture.status() != SELVAGE_OK) return failed(texture.status());
  std::vector<uint32_t> pixels(static_cast<size_t>(work.target_width_px * work.target_height_px),
                               kUntouched);
  const selvage_image target{pixels.data(), work.target_width_px, work.target_height_px,
                             work.target_width_px * kPixelBytes, SELVAGE_RGBA8888};
  selvage_options options{};
  options.filter = work.filter;
  options.address = work.address;
  options.kernel = kernel;
  Drawing drawing(work, target, texture.get(), options);
  selvage_status status = drawing.draw();
  if (status != SELVAGE_OK) return failed(status);
  CALLGRIND_START_INSTRUMENTATION;
  CALLGRIND_ZERO_STATS;
  status = drawing.draw();
  CALLGRIND_DUMP_STATS_AT(kind);
  CALLGRIND_STOP_INSTRUMENTATION;
  if (status != SELVAGE_OK) return failed(status);

  size_t units = work.polygons.size();
  if (work.unit == "px") {
    units = pixels.size() - static_cast<size_t>(std::ranges::count(pixels, kUntouched));
  }
  std::printf("%s %zu %.*s\n", kind, units, static_cast<int>(work.unit.size()), work.unit.data());
  std::fflush(stdout);  // who counts shows each as it comes
  return kFine;
}

int wrong_use(const char* what, std::string_view word) {
  std::fprintf(stderr, "selvage_work: %s%.*s; see --help\n", what, static_cast<int>(word.size()),
               word.data());
  return kWrongUse;
}

int run(std::span<char*> arguments) {
  const std::string_view first = arguments.size() > 1 ? arguments[1] : "";
  if (arguments.size() == 2 && first == "--help") return std::fputs(kUsage, stdout), kFine;
  if (arguments.size() == 2 && first == "--build") return std::puts(SELVAGE_BUDGET_BUILD), kFine;
  if (arguments.size() < 3) return wrong_use("wanted are a kernel and a kind or some", "");
  const auto kernel = kernel_of(first);
  if (!kernel) return wrong_use("no such kernel: ", first);
  const std::span<char*> kinds = arguments.subspan(2);
  for (const char* kind : kinds) {
    if (!work_of(kind)) return wrong_use("no such kind: ", kind);
  }
  if (selvage_has_kernel(*kernel) == 0) return kNotHere;
  for (const char* kind : kinds) {
    if (const int result = draw_and_count(kind, *work_of(kind), *kernel); result != kFine) {
      return result;
    }
  }
  return kFine;
}

}  // namespace
}  // namespace selvage::budget

int main(int count, char** arguments) {
  return selvage::budget::run({arguments, static_cast<size_t>(count)});
}
