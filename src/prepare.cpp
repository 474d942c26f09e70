// selvage_prepare: every argument is checked here, then the texture is laid out anew.
#include <cstddef>
#include <cstdint>

#include "mapper/image_check.h"
#include "mapper/prepare.h"
#include "selvage.h"

namespace {

using namespace selvage::mapper;

[[nodiscard]] selvage_status check_wish(const selvage_texture* source, selvage_layout layout,
                                        int32_t with_sums) {
  if (const selvage_status status = check_texture(source); status != SELVAGE_OK) return status;
  if (!layout_is_known(layout)) return SELVAGE_ERROR_PREPARE_LAYOUT;
  return with_sums != 0 && source->format != SELVAGE_RGBA8888 ? SELVAGE_ERROR_PREPARE_SUMS
                                                              : SELVAGE_OK;
}

// The memory from its first byte on meets nothing that is read or written beside it.
[[nodiscard]] selvage_status check_memory(const selvage_texture* source, const void* memory,
                                          size_t bytes, size_t wanted_bytes,
                                          const selvage_texture* prepared) {
  if (memory == nullptr || prepared == nullptr) return SELVAGE_ERROR_PREPARE_NULL;
  const auto begin = reinterpret_cast<uintptr_t>(memory);
  if (begin % SELVAGE_PREPARED_ALIGNMENT != 0) return SELVAGE_ERROR_PREPARE_ALIGNMENT;
  if (bytes < wanted_bytes || wanted_bytes > UINTPTR_MAX - begin) return SELVAGE_ERROR_PREPARE_SIZE;
  const Memory written{begin, begin + wanted_bytes};
  const auto meets = [&](const selvage_texture* descriptor) {
    return written.meets(memory_of(descriptor, 1, sizeof *descriptor));
  };
  const bool shared = written.meets(memory_of(*source)) || meets(source) || meets(prepared);
  return shared ? SELVAGE_ERROR_PREPARE_OVERLAP : SELVAGE_OK;
}

}  // namespace

size_t selvage_prepare_bytes(const selvage_texture* source, selvage_layout layout,
                             int32_t with_sums) {
  if (check_wish(source, layout, with_sums) != SELVAGE_OK) return SIZE_MAX;
  return preparation(*source, layout, with_sums != 0).bytes;
}

selvage_status selvage_prepare(const selvage_texture* source, selvage_layout layout,
                               int32_t with_sums, void* memory, size_t bytes,
                               selvage_texture* prepared) {
  selvage_status status = check_wish(source, layout, with_sums);
  if (status != SELVAGE_OK) return status;
  const Preparation plan = preparation(*source, layout, with_sums != 0);
  status = check_memory(source, memory, bytes, plan.bytes, prepared);
  if (status == SELVAGE_OK) *prepared = prepare(*source, plan, memory);
  return status;
}
