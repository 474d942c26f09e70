// Draws stated workloads, each once unseen and once to be counted, by valgrind's callgrind or an
// instruction at a time: what tests/budget/run runs.
#include <valgrind/callgrind.h>

#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "drawing.h"
#include "steps.h"
#include "work.h"

namespace selvage::budget {
namespace {

enum Exit { kFine = 0, kFailed = 1, kWrongUse = 2, kNotHere = 3 };

constexpr const char* kUsage =
    "Usage: selvage_work [--steps] KERNEL KIND...\n"
    "       selvage_work --build\n\n"
    "Draws each KIND (mesh-52, mesh-484, tilted-52, tilted-484, affine, perspective, bilinear,\n"
    "bilinear-any, area, area-tilted, area-ruled, area-sums, quads, quad-tilted; an adversarial\n"
    "item of the report, A1 to A14, or its twin, A1-ordinary to A14-ordinary; a map of\n"
    "`selvage bench --near-ties`, seed-N, or a twin of it, seed-N-ordinary; any of these with\n"
    "-flipped behind it, from a texture stored bottom row first, or -list, by one call) twice\n"
    "with KERNEL (scalar, sse4, avx2, avx512). Under valgrind's callgrind with\n"
    "--instr-atstart=no the second drawing alone is counted, and dumped under the KIND's name.\n"
    "After each, prints what was drawn: KIND UNITS UNIT.\n"
    "With --steps, without valgrind: counts the second drawing an instruction at a time and\n"
    "prints KIND UNITS UNIT INSTRUCTIONS. That is slow, so there is less of each: the first 64\n"
    "triangles, or 8 polygons; of fewer 8 rows in their middle (area: 2).\n"
    "With --build, prints the compiler and the kind of build.\n\n"
    "Examples:\n"
    "  selvage_work scalar mesh-52 A1\n"
    "  selvage_work --steps avx512 affine\n\n"
    "Exit status: 0 drawn, 1 refused by the mapper, 2 wrong use, 3 no such kernel here, or no\n"
    "such way to count.\n";

enum class Counter { kCallgrind, kSteps };

std::optional<selvage_kernel> kernel_of(std::string_view name) {
  if (name == "scalar") return SELVAGE_KERNEL_SCALAR;
  if (name == "sse4") return SELVAGE_KERNEL_SSE4;
  if (name == "avx2") return SELVAGE_KERNEL_AVX2;
  if (name == "avx512") return SELVAGE_KERNEL_AVX512;
  return std::nullopt;
}

// By callgrind, which tells them itself.
selvage_status draw_for_callgrind(const char* kind, Drawing& drawing) {
  CALLGRIND_START_INSTRUMENTATION;
  CALLGRIND_ZERO_STATS;
  const selvage_status status = drawing.draw();
  CALLGRIND_DUMP_STATS_AT(kind);
  CALLGRIND_STOP_INSTRUMENTATION;
  return status;
}

// What a first drawing alone does, such as finding out what the machine has, is not counted.
int draw_and_count(const char* kind, const Work& work, selvage_kernel kernel, Counter counter) {
  Drawing drawing(work, kernel);
  uint64_t steps = 0;
  selvage_status status = drawing.draw();
  if (status == SELVAGE_OK) {
    if (counter == Counter::kSteps) {
      steps = instructions_of([&] { status = drawing.draw(); });
    } else {
      status = draw_for_callgrind(kind, drawing);
    }
  }
  if (status != SELVAGE_OK) {
    std::fprintf(stderr, "selvage_work: %s: %s\n", kind, selvage_status_text(status));
    return kFailed;
  }
  std::printf("%s %zu %.*s", kind, drawing.units(), static_cast<int>(work.unit.size()),
              work.unit.data());
  if (counter == Counter::kSteps) std::printf(" %" PRIu64, steps);
  std::puts("");
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
  const Counter counter = first == "--steps" ? Counter::kSteps : Counter::kCallgrind;
  arguments = arguments.subspan(counter == Counter::kSteps ? 2 : 1);
  if (arguments.size() < 2) return wrong_use("wanted are a kernel and a kind or some", "");
  const auto kernel = kernel_of(arguments[0]);
  if (!kernel) return wrong_use("no such kernel: ", arguments[0]);
  const std::span<char*> kinds = arguments.subspan(1);
  for (const char* kind : kinds) {
    if (!work_of(kind)) return wrong_use("no such kind: ", kind);
  }
  if (selvage_has_kernel(*kernel) == 0) return kNotHere;
  if (counter == Counter::kSteps && !kCountsSteps) return kNotHere;
  for (const char* kind : kinds) {
    Work work = *work_of(kind);
    if (counter == Counter::kSteps) work = excerpt_of(std::move(work));
    if (const int result = draw_and_count(kind, work, *kernel, counter); result != kFine) {
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
