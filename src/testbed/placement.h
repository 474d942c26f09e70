// Where the arguments of one call lie: in the caller's memory, and in the arenas that the subject
// sees. Each kind of them ends at a guard, or begins at one.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "testbed/arena.h"
#include "testbed/control.h"

namespace selvage::testbed {

// The memory that the subject is given, apart from the control block.
struct Arenas {
  Arena target{size_t{16} << 20};
  Arena texture{size_t{16} << 20};         // read-only to the subject, as those below
  Arena other_textures{size_t{16} << 20};  // a call's second texture and on
  Arena vertices{size_t{1} << 20};
  Arena polygons{size_t{64} << 10};
  Arena structures{4096};
  // Each holds one prepared texture, which can be written while it is prepared.
  std::array<Arena, 4> prepared{Arena{size_t{16} << 20}, Arena{size_t{16} << 20},
                                Arena{size_t{16} << 20}, Arena{size_t{16} << 20}};
  Arena scratch{size_t{16} << 20};  // it may write to these two
  Arena results{4096};
};

// Bytes of the caller's and where they are copied to.
struct Placed {
  Range from;  // empty: an argument so bad that nothing of it can be copied
  uintptr_t at = 0;

  [[nodiscard]] Range range() const { return {at, at + from.bytes()}; }
  [[nodiscard]] uintptr_t moved(const void* pointer) const {
    return at + (reinterpret_cast<uintptr_t>(pointer) - from.begin);
  }
};

class Placement {
 public:
  // Plans the call; its pointers are the caller's, but for its memory, which is where it is to be.
  // Textures that lie in what was `prepared` stay where that is. Throws spec::NotClaimed where a
  // call has more polygons and textures than there is room for.
  Placement(const Arenas& arenas, const Call& call, const std::vector<Placed>& prepared,
            bool at_end);

  // Copies what is the caller's in, and gives the call as the subject sees it.
  [[nodiscard]] Call copy_in() const;
  // Copies the target back, with what lies between its rows, and what it answers in structures.
  void copy_out() const;

  // "just after the end of the target, where pixel (8, 5) would be"; empty if it is near nothing
  // that was given.
  [[nodiscard]] std::string place_of(uintptr_t address) const;

 private:
  struct PlacedTexture {
    const selvage_texture* texture;
    Placed placed;
    bool is_copied;  // and not prepared before
  };

  void place_textures(const std::vector<Placed>& prepared);
  void place_vertices();
  void place_target();
  [[nodiscard]] selvage_polygon* copy_polygons_in(uintptr_t* at) const;
  [[nodiscard]] const PlacedTexture* placed_of(const selvage_texture* texture) const;
  [[nodiscard]] std::string place_in_memory(uintptr_t address) const;
  [[nodiscard]] std::string place_in_textures(uintptr_t address) const;

  const Arenas& arenas_;
  Call call_;
  bool at_end_;
  Placed target_;
  std::vector<PlacedTexture> textures_;
  std::vector<Placed> vertices_;  // of the polygons
};

}  // namespace selvage::testbed
