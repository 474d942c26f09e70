// Law MEM, its last part: the draw path allocates nothing. The linker wraps every allocation
// function that the mapper's objects may call, aligned and nothrow forms included.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <vector>

#include "spec/canvas.h"
#include "spec/generate.h"
#include "spec/profiles.h"
#include "spec/texture_memory.h"

namespace {
size_t allocations = 0;
}  // namespace

extern "C" {
// NOLINTBEGIN: these names are the linker's.
void* __real_malloc(size_t size);
void* __real_calloc(size_t count, size_t size);
void* __real_realloc(void* memory, size_t size);
void* __real__Znwm(size_t size);
void* __real__Znam(size_t size);

void* __wrap_malloc(size_t size) { return ++allocations, __real_malloc(size); }
void* __wrap_calloc(size_t count, size_t size) { return ++allocations, __real_calloc(count, size); }
void* __wrap_realloc(void* memory, size_t size) {
  return ++allocations, __real_realloc(memory, size);
}
void* __wrap__Znwm(size_t size) { return ++allocations, __real__Znwm(size); }
void* __wrap__Znam(size_t size) { return ++allocations, __real__Znam(size); }

// The other forms of new, and what aligns: nothing here may call them either.
void* __wrap__ZnwmRKSt9nothrow_t(size_t size, const void*) {
  return ++allocations, __real__Znwm(size);
}
void* __wrap__ZnamRKSt9nothrow_t(size_t size, const void*) {
  return ++allocations, __real__Znwm(size);
}
void* __wrap__ZnwmSt11align_val_t(size_t size, size_t) { return ++allocations, __real__Znwm(size); }
void* __wrap__ZnamSt11align_val_t(size_t size, size_t) { return ++allocations, __real__Znwm(size); }
void* __wrap_aligned_alloc(size_t, size_t size) { return ++allocations, __real_malloc(size); }
int __wrap_posix_memalign(void** memory, size_t, size_t size) {
  ++allocations;
  *memory = __real_malloc(size);
  return 0;
}
// NOLINTEND
}

namespace selvage::spec {
namespace {

TEST(Allocation, TheCounterCounts) {
  const size_t before = allocations;
  void* memory = ::operator new(100);  // a new expression the compiler may leave out
  EXPECT_GT(allocations, before);
  ::operator delete(memory);

  const size_t before_nothrow = allocations;
  memory = ::operator new(100, std::nothrow);
  EXPECT_GT(allocations, before_nothrow);
  ::operator delete(memory, std::nothrow);
}

TEST(Allocation, PreparingAllocatesNothing) {
  for (uint64_t seed = 1; seed <= 200; ++seed) {
    const Case c = generate(seed);
    const Canvas texels(c.format, c.texture_width_texel, c.texture_height_texel, c.padding_px,
                        c.flip_texture, 1);
    const selvage_texture source = texels.texture();
    const int32_t with_sums = c.format == SELVAGE_RGBA8888 ? 1 : 0;
    for (const selvage_layout layout : {SELVAGE_LAYOUT_ROWS, SELVAGE_LAYOUT_TILES}) {
      const size_t bytes = selvage_prepare_bytes(&source, layout, with_sums);
      std::vector<std::byte> memory(bytes + SELVAGE_PREPARED_ALIGNMENT);
      void* aligned = memory.data();
      size_t space = memory.size();
      ASSERT_NE(std::align(SELVAGE_PREPARED_ALIGNMENT, bytes, aligned, space), nullptr);
      selvage_texture prepared{};
      const size_t before = allocations;
      const selvage_status status =
          selvage_prepare(&source, layout, with_sums, aligned, bytes, &prepared);
      const size_t after = allocations;
      ASSERT_EQ(status, SELVAGE_OK);
      ASSERT_EQ(after, before);
    }
  }
}

TEST(Allocation, DrawingAllocatesNothing) {
  uint64_t drawn = 0;
  for (uint64_t seed = 1; seed <= 2000; ++seed) {
    const Case c = in_profile(generate(seed), profiles()[seed % profiles().size()].id);
    Canvas canvas(c.format, c.target_width_px, c.target_height_px, c.padding_px, c.flip_target, 0);
    const TextureMemory texels(
        built_in(c.profile), c, [](Texel) { return 0x01010101U; }, 1);
    const selvage_image image = canvas.image();
    const selvage_texture texture = texels.view();
    const selvage_options options{c.profile, c.filter, c.address, 0, 0};

    const size_t before = allocations;
    const selvage_status status =
        selvage_draw(&image, c.has_clip ? &c.clip : nullptr, c.vertices.data(), c.vertices.size(),
                     &texture, &options);
    const size_t after = allocations;
    ASSERT_EQ(after, before) << print(c);
    if (status == SELVAGE_OK) ++drawn;
  }
  EXPECT_GT(drawn, 1000U);
}

TEST(Allocation, MeasuringAllocatesNothing) {
  alignas(std::max_align_t) static std::array<std::byte, SELVAGE_FASTEST_KERNEL_BYTES> scratch;
  selvage_kernel fastest = SELVAGE_KERNEL_FASTEST;
  const size_t before = allocations;
  const selvage_status status =
      selvage_fastest_kernel(SELVAGE_FILTER_NEAREST, SELVAGE_RGBA8888, SELVAGE_WORK_MESH,
                             scratch.data(), scratch.size(), &fastest);
  const size_t after = allocations;
  EXPECT_EQ(status, SELVAGE_OK);
  EXPECT_EQ(after, before);
}

// What oneTBB allocates for its threads lies in its own library and is not counted.
TEST(Allocation, DrawingManyAllocatesNothing) {
  std::vector<uint32_t> pixels(64 * 64), texels(8 * 8, 7);
  const selvage_image image{pixels.data(), 64, 64, 64 * 4, SELVAGE_RGBA8888};
  const selvage_texture texture{texels.data(),       8,      8, 8 * 4, SELVAGE_RGBA8888,
                                SELVAGE_LAYOUT_ROWS, nullptr};
  const selvage_vertex corners[3] = {{0, 0, 0, 0, 1}, {16384, 300, 0, 0, 1}, {200, 16384, 0, 0, 1}};
  const std::vector<selvage_polygon> polygons(2000, {corners, 3, &texture});
  std::vector<std::byte> scratch(selvage_draw_many_bytes(polygons.size()));
  for (const int32_t threads : {1, 2, 0}) {
    const size_t before = allocations;
    const selvage_status status =
        selvage_draw_many(&image, nullptr, polygons.data(), polygons.size(), nullptr, threads,
                          scratch.data(), scratch.size(), nullptr);
    const size_t after = allocations;
    EXPECT_EQ(status, SELVAGE_OK);
    EXPECT_EQ(after, before) << threads << " threads";
  }
  EXPECT_EQ(pixels[64 * 20 + 20], 7U);
}

}  // namespace
}  // namespace selvage::spec
