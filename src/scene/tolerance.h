// How large a tolerance may be. It needs nothing of the scenes, so that it is there without them.
#pragma once

namespace selvage::scene {

// selvage_options has it in 16.16: the most whole texels of that.
inline constexpr double kMostTolerance_texel = 32767;

}  // namespace selvage::scene
