// Hostile calls, of images: what a target and a texture are said to be, and where they lie.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "spec/case.h"
#include "spec/hostile_calls.h"

namespace selvage::spec {

inline constexpr int32_t kInt32Min = std::numeric_limits<int32_t>::min();
inline constexpr int32_t kInt32Max = std::numeric_limits<int32_t>::max();

using Calls = std::vector<HostileCall>;

// Each of both images with one number that is wrong.
void spoil_images(Calls* calls, selvage_format format);
// Rows as given, said to be what they are not. What is legal all the same is asked of a subject
// that takes such textures.
void spoil_preparation(Calls* calls, const Case& c, const Capabilities& claims);
// Where the two share memory, and where they only seem to; likewise.
void share_memory(Calls* calls, const Case& c, const Capabilities& claims);

}  // namespace selvage::spec
