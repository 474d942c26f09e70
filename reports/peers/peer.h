// The mappers of other projects as subjects, a file each. What its library was not found for is not
// defined; peers.cpp knows which are.
#pragma once

#include <string>

#include "reports/bench/subject.h"

namespace selvage::reports {

struct Peer {
  Subject subject;
  std::string build_information;  // its version and configuration as it states them when run
};

[[nodiscard]] Peer peer_agg();
[[nodiscard]] Peer peer_allegro();
[[nodiscard]] Peer peer_cairo();
[[nodiscard]] Peer peer_llvmpipe();
[[nodiscard]] Peer peer_opencv();
[[nodiscard]] Peer peer_pixman();
[[nodiscard]] Peer peer_qt();
[[nodiscard]] Peer peer_sdl();

// The three lower bytes: what survives in formats of 32 bits whose fourth byte is unused. Of a
// texel (s, t) that is s, and t modulo 256.
inline constexpr uint32_t kThreeBytes = 0x00FFFFFF;

// A vertex's coordinates as the numbers other libraries want.
[[nodiscard]] inline double x_px(const selvage_vertex& vertex) { return vertex.x / 256.0; }
[[nodiscard]] inline double y_px(const selvage_vertex& vertex) { return vertex.y / 256.0; }
[[nodiscard]] inline double u_texel(const selvage_vertex& vertex) { return vertex.u / 65536.0; }
[[nodiscard]] inline double v_texel(const selvage_vertex& vertex) { return vertex.v / 65536.0; }

}  // namespace selvage::reports
