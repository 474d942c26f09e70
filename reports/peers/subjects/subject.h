// A peer as a subject of the laws: a library that exports selvage_draw and says what it promises.
// Each file beside this one states a peer's claims, and where its documentation makes them.
#pragma once

#include "reports/peers/painter.h"
#include "selvage_subject.h"

namespace selvage::reports {

inline constexpr uint32_t kNearest = 1u << SELVAGE_FILTER_NEAREST;
inline constexpr uint32_t kNearestAndBilinear = kNearest | 1u << SELVAGE_FILTER_BILINEAR;
inline constexpr uint32_t kClamp = 1u << SELVAGE_ADDRESS_CLAMP;
inline constexpr uint32_t kWrap = 1u << SELVAGE_ADDRESS_WRAP;

// What no peer has: the names of our errors, and pictures stored bottom row first.
inline constexpr uint32_t kPeersLack = SELVAGE_LACKS_NAMED_ERRORS | SELVAGE_LACKS_NEGATIVE_PITCH;

// The claims of a mapper of triangles of RGBA8888: whoever takes one matrix takes no other polygon.
[[nodiscard]] constexpr selvage_claims claims_of_triangles(const char* name, const char* version,
                                                           uint32_t filters, uint32_t addresses,
                                                           uint32_t lacks) {
  selvage_claims claims{};
  claims.bytes = sizeof(selvage_claims);
  claims.name = name;
  claims.version = version;
  claims.formats = 1u << SELVAGE_RGBA8888;
  claims.filters = filters;
  claims.addresses = addresses;
  claims.lacks = kPeersLack | lacks;
  claims.most_vertices = 3;
  return claims;
}

struct PeerSubject {
  selvage_claims claims;
  MakePainter paint;
};

// Defined once in each library.
[[nodiscard]] const PeerSubject& peer_subject();

}  // namespace selvage::reports
