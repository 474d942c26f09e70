// Raw hostile arguments -> selvage_draw. Laws TOTAL and MEM: a picture or a named error, an error
// draws nothing, nothing outside the clip or between the rows is written, inputs stay as they were.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "fuzz/hostile_call.h"

namespace {

void require(bool holds, const char* what, selvage_status status) {
  if (holds) return;
  std::fprintf(stderr, "selvage_draw: %s (status %d: %s)\n", what, status,
               selvage_status_text(status));
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  selvage::fuzz::Call call{selvage::fuzz::Bytes(data, size)};
  const selvage::fuzz::Block target_before = call.target_block;
  const selvage::fuzz::Block texture_before = call.texture_block();
  const std::vector<selvage_vertex> vertices_before = call.vertices;
  const selvage_status status = call.draw();

  require(status >= SELVAGE_OK && status < SELVAGE_STATUS_COUNT, "a status without a name", status);
  require(
      call.vertices.empty() || std::memcmp(call.vertices.data(), vertices_before.data(),
                                           vertices_before.size() * sizeof(selvage_vertex)) == 0,
      "wrote to the vertices", status);
  if (status != SELVAGE_OK) {
    require(call.target_block == target_before, "drew in spite of an error", status);
    return 0;
  }
  require(!call.vertices_in_target, "drew over its own vertices", status);
  require(same_texels(call.texture_block(), texture_before, call), "wrote to the texture", status);
  require(same_elsewhere(call.target_block, target_before, call), "wrote outside the clip", status);
  return 0;
}
