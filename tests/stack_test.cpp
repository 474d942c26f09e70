// How much stack a call takes, as selvage.h promises: seen from a thread whose stack is filled with
// a pattern before each call.
#include <gtest/gtest.h>

#include <pthread.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <tuple>
#include <vector>

#include "selvage.h"
#include "spec/verify.h"

namespace selvage {
namespace {

constexpr size_t kStack_bytes = size_t{128} * 1024;
constexpr uint8_t kUntouched = 0x5A;

// A thread of its own for each call.
class PaintedStack {
 public:
  // The bytes between the stack's end and what the call touched last.
  [[nodiscard]] size_t taken_by(std::function<void()> call) {
    std::fill(bytes_.begin(), bytes_.end(), kUntouched);
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    EXPECT_EQ(pthread_attr_setstack(&attributes, bytes_.data(), bytes_.size()), 0);
    const auto run = [](void* of) -> void* {
      (*static_cast<std::function<void()>*>(of))();
      return nullptr;
    };
    pthread_t thread;
    EXPECT_EQ(pthread_create(&thread, &attributes, run, &call), 0);
    EXPECT_EQ(pthread_join(thread, nullptr), 0);
    pthread_attr_destroy(&attributes);
    const auto touched =
        std::find_if(bytes_.begin(), bytes_.end(), [](uint8_t byte) { return byte != kUntouched; });
    return static_cast<size_t>(bytes_.end() - touched);
  }

 private:
  std::vector<uint8_t> bytes_ = std::vector<uint8_t>(kStack_bytes);
};

// Whether the options leave the kernel to the subject: law SAME asks for each of them.
[[nodiscard]] bool leaves_kernel(const selvage_options* options) {
  return options == nullptr || options->kernel == SELVAGE_KERNEL_FASTEST;
}

// Draws a list on the caller's thread, whatever number of threads is asked for.
[[nodiscard]] spec::DrawMany on_one_thread(const spec::DrawMany& draw_many) {
  return [draw_many](const selvage_image* target, const selvage_rect* clip,
                     const selvage_polygon* polygons, size_t count, const selvage_options* options,
                     int32_t threads, size_t* failed) {
    return draw_many(target, clip, polygons, count, options, threads < 0 ? threads : 1, failed);
  };
}

// Of the calls that the laws make of a subject, what the thread takes for itself apart.
[[nodiscard]] size_t most_taken(spec::Subject subject) {
  PaintedStack stack;
  const size_t idle_bytes = stack.taken_by([] {});
  size_t most_bytes = 0;
  const auto watched = [&](auto call) {
    return [&, call](auto... arguments) {
      if (!leaves_kernel(std::get<const selvage_options*>(std::tuple(arguments...)))) {
        return call(arguments...);
      }
      selvage_status status = SELVAGE_OK;
      const size_t bytes = stack.taken_by([&] { status = call(arguments...); });
      most_bytes = std::max(most_bytes, bytes - std::min(bytes, idle_bytes));
      return status;
    };
  };
  subject.draw = watched(subject.draw);
  subject.draw_many = watched(subject.draw_many);
  subject.choose = watched(subject.choose);
  for (const spec::Law& law : spec::laws()) {
    const spec::LawVerdict verdict = spec::verify(law, subject, /*first_seed=*/1, 30);
    EXPECT_FALSE(verdict.violation) << spec::explain(*verdict.violation);
  }
  testing::Test::RecordProperty("most_bytes", static_cast<int>(most_bytes));
  return most_bytes;
}

// Wide rows in perspective, of a list that is shared out.
[[nodiscard]] size_t taken_by_a_list(selvage_kernel kernel) {
  constexpr int32_t kWidth_px = 2048, kHeight_px = 512, kSide_texel = 64;
  constexpr int32_t kRight = kWidth_px * SELVAGE_SUBPIXELS,
                    kBottom = kHeight_px * SELVAGE_SUBPIXELS;
  constexpr int32_t kEnd = kSide_texel * SELVAGE_SUBTEXELS;
  std::vector<uint32_t> pixels(size_t{kWidth_px} * kHeight_px), texels(kSide_texel * kSide_texel);
  const selvage_image target{pixels.data(), kWidth_px, kHeight_px, kWidth_px * 4, SELVAGE_RGBA8888};
  const selvage_texture texture{texels.data(),    kSide_texel,         kSide_texel, kSide_texel * 4,
                                SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, nullptr};
  const selvage_vertex corners[] = {{0, 0, 0, 0, 1000},
                                    {kRight, 7, kEnd, 0, 1300},
                                    {kRight, kBottom, kEnd, kEnd, 900},
                                    {0, kBottom, 0, kEnd, 1100}};
  const std::vector<selvage_polygon> list(20, {corners, 4, &texture});
  selvage_options options{};
  options.kernel = kernel;
  const size_t scratch_bytes = selvage_draw_many_bytes(list.size());
  std::vector<std::max_align_t> scratch(scratch_bytes / sizeof(std::max_align_t) + 1);
  PaintedStack stack;
  const size_t idle_bytes = stack.taken_by([] {});
  size_t most_bytes = 0;
  for (int i = 0; i < 5; ++i) {  // which of them the caller's thread draws, is chance
    const size_t bytes = stack.taken_by([&] {
      EXPECT_EQ(selvage_draw_many(&target, nullptr, list.data(), list.size(), &options, 2,
                                  scratch.data(), scratch_bytes, nullptr),
                SELVAGE_OK);
    });
    most_bytes = std::max(most_bytes, bytes - std::min(bytes, idle_bytes));
  }
  return most_bytes;
}

constexpr size_t kKilobyte = 1024;

TEST(Stack, ACallTakesNinetySixKilobytes) {
  for (const selvage_kernel kernel :
       {SELVAGE_KERNEL_SCALAR, SELVAGE_KERNEL_SSE4, SELVAGE_KERNEL_AVX2, SELVAGE_KERNEL_AVX512,
        SELVAGE_KERNEL_NEON}) {
    if (selvage_has_kernel(kernel) == 0) continue;
    SCOPED_TRACE(kernel);
    spec::Subject subject = spec::built_in();
    spec::take_kernel(kernel, &subject);
    const size_t most_bytes = std::max(most_taken(subject), taken_by_a_list(kernel));
    EXPECT_LE(most_bytes, 96 * kKilobyte);
    EXPECT_GT(most_bytes, kKilobyte) << "something was seen";
  }
}

TEST(Stack, MeasuringKernelsTakesNoMore) {
  PaintedStack stack;
  std::vector<std::max_align_t> trial(SELVAGE_FASTEST_KERNEL_BYTES / sizeof(std::max_align_t) + 1);
  const size_t bytes = stack.taken_by([&] {
    selvage_kernel kernel;
    EXPECT_EQ(
        selvage_fastest_kernel(SELVAGE_FILTER_NEAREST, SELVAGE_RGBA8888, SELVAGE_WORK_PERSPECTIVE,
                               trial.data(), SELVAGE_FASTEST_KERNEL_BYTES, &kernel),
        SELVAGE_OK);
  });
  EXPECT_LE(bytes, 96 * kKilobyte);
}

TEST(Stack, ACallTakesTwentyAtMostWithoutVectorsAndThreads) {
  spec::Subject subject = spec::built_in();
  spec::take_kernel(SELVAGE_KERNEL_SCALAR, &subject);
  subject.draw_many = on_one_thread(subject.draw_many);
  const size_t most_bytes = most_taken(subject);
  EXPECT_LE(most_bytes, (sizeof(void*) == 4 ? 16 : 20) * kKilobyte);
  EXPECT_GT(most_bytes, kKilobyte) << "something was seen";
}

}  // namespace
}  // namespace selvage
