// The texture of a case in memory: as the case has it, or laid out anew by the subject.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "spec/canvas.h"
#include "spec/case.h"
#include "spec/filter.h"
#include "spec/subject.h"

namespace selvage::spec {

// The layout that the subject draws the case from: tiles are for the exact profile alone, and
// without a call that prepares textures there are only rows as given.
[[nodiscard]] Layout layout_of(const Subject& subject, const Case& c);

class TextureMemory {
 public:
  // All bytes that are no texels start as `outside`.
  TextureMemory(const Subject& subject, const Case& c, const TexelAt& texel_at, uint8_t outside);
  TextureMemory(const TextureMemory&) = delete;  // the view points into it
  TextureMemory& operator=(const TextureMemory&) = delete;
  ~TextureMemory();

  // Other texels in the same memory, prepared there anew where they were.
  void change(const Subject& subject, const Case& c, const TexelAt& texel_at);

  // Of preparing it, and what that has written and may not; nothing if it is fine.
  [[nodiscard]] selvage_status status() const { return status_; }
  [[nodiscard]] const std::string& fault() const { return fault_; }

  [[nodiscard]] const selvage_texture& view() const { return view_; }

  // All of it, to be compared.
  struct Bytes {
    Canvas given;
    std::vector<uint8_t> prepared;
    friend bool operator==(const Bytes&, const Bytes&) = default;
  };
  [[nodiscard]] Bytes bytes() const { return {given_, memory_}; }

 private:
  void lay_out(const Subject& subject, const Case& c);
  void prepare(const Prepare& prepare, selvage_layout layout, bool with_sums);

  uint8_t outside_;
  Canvas given_;
  std::vector<uint8_t> memory_;  // with guards on both sides
  selvage_texture view_{};
  std::function<void()> release_;  // what was prepared in it
  selvage_status status_ = SELVAGE_OK;
  std::string fault_;
};

}  // namespace selvage::spec
