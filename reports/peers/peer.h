// The mappers of other projects as subjects of the benchmark, a file each. What its library was not
// found for is not defined; peers.cpp knows which are.
#pragma once

#include <memory>
#include <string>

#include "reports/bench/subject.h"
#include "reports/peers/painter.h"

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

// For Subject::prepare: the painter is made beforehand, its drawing is timed.
[[nodiscard]] inline auto prepared_by(MakePainter make) {
  return [make](const Workload& load, const Texture& texture,
                Target& target) -> std::function<void()> {
    const std::shared_ptr<Painter> painter = make({.target = target.image(),
                                                   .texture = texture.view(),
                                                   .filter = load.filter,
                                                   .perspective = load.perspective});
    return [&load, painter] { painter->draw(load.polygons); };
  };
}

}  // namespace selvage::reports
