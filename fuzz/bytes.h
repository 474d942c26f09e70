// Reads a fuzzer's bytes as numbers. What lies past the end reads as zero, so every input is
// complete. Plain C++: it works under every compiler and engine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace selvage::fuzz {

class Bytes {
 public:
  Bytes(const uint8_t* data, size_t size) : rest_(data, size) {}

  // The next sizeof(Number) bytes in the machine's order.
  template <typename Number>
  [[nodiscard]] Number take() {
    Number number{};
    const size_t count = rest_.size() < sizeof(Number) ? rest_.size() : sizeof(Number);
    if (count > 0) std::memcpy(&number, rest_.data(), count);
    rest_ = rest_.subspan(count);
    return number;
  }

  [[nodiscard]] size_t left() const { return rest_.size(); }

 private:
  std::span<const uint8_t> rest_;
};

}  // namespace selvage::fuzz
