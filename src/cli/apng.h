// Animated PNG: frames of one size, shown one after another, for ever.
//
// Source: Portable Network Graphics (third edition), W3C: acTL, fcTL and fdAT. Programs that know
// nothing of animations show the first frame.
#pragma once

#include <cstdint>
#include <vector>

#include "cli/raster.h"

namespace selvage::cli {

// How long a frame is shown: numerator / denominator seconds, the denominator not 0.
struct FrameDelay {
  uint16_t numerator = 1, denominator = 25;
  friend bool operator==(const FrameDelay&, const FrameDelay&) = default;
};

// The nearest convergent to 1 / rate; exact where the rate is a whole number. A UserError unless
// 1 <= rate <= 65535 or 1 <= 1 / rate <= 65535.
[[nodiscard]] FrameDelay frame_delay(double frames_per_s);

class Apng {
 public:
  Apng(uint32_t frames, const FrameDelay& delay) : frames_(frames), delay_(delay) {}

  // All frames are of the size of the first.
  void add(const Raster& raster);
  // After exactly as many frames as were announced. The bytes are moved out.
  [[nodiscard]] std::vector<uint8_t> finish();

 private:
  void add_control(const Raster& raster);

  uint32_t frames_, added_ = 0;
  uint32_t sequence_ = 0;  // of fcTL and fdAT together
  FrameDelay delay_;
  int32_t width_px_ = 0, height_px_ = 0;
  std::vector<uint8_t> bytes_;
};

}  // namespace selvage::cli
