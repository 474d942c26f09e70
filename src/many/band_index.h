// Which polygons reach which bands: a bit for each of both.
//
// A group is 64 polygons that follow each other: a word for each band, in which each of them has a
// bit. The words of all bands lie side by side, so that those of some bands are united while they
// are read.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "many/bands.h"

namespace selvage::many {

class BandIndex {
 public:
  static constexpr size_t kPolygonsPerGroup = 64;

  struct Group {
    BandRange reached;  // all that are, and those between: other words are not written, nor read
    std::array<uint64_t, kMostBands> words;
  };

  [[nodiscard]] static constexpr size_t groups(size_t polygons) {
    return (polygons + kPolygonsPerGroup - 1) / kPolygonsPerGroup;
  }

  // As many as groups(..) for all polygons. Each is written before it is read.
  BandIndex(const Bands& bands, std::span<Group> groups) : bands_(bands), groups_(groups) {}

  [[nodiscard]] const Bands& bands() const { return bands_; }

  // Lists polygons one after another: from a multiple of kPolygonsPerGroup on, up to another one or
  // the last of all. Others may list other ones at the same time.
  class Writer {
   public:
    Writer(const BandIndex& index, size_t first) : groups_(index.groups_), polygon_(first) {}

    // The next one, which reaches these bands. A loop over them would end each time where no
    // processor foresees it.
    void add(BandRange bands) {
      const uint64_t bit = uint64_t{1} << (polygon_ % kPolygonsPerGroup);
      if (bands.count() != 0) {
        turns_[bands.first] ^= bit;
        turns_[bands.end] ^= bit;
        reached_ = {std::min(reached_.first, bands.first), std::max(reached_.end, bands.end)};
      }
      if (++polygon_ % kPolygonsPerGroup == 0) write(polygon_ - 1);
    }
    void end() {
      if (polygon_ % kPolygonsPerGroup != 0) write(polygon_);
    }

   private:
    static constexpr BandRange kNone{kMostBands, 0};

    void write(size_t polygon) {
      Group& group = groups_[polygon / kPolygonsPerGroup];
      group.reached = reached_;
      uint64_t bits = 0;
      for (size_t band = reached_.first; band < reached_.end; ++band) {
        bits ^= turns_[band];
        group.words[band] = bits;
        turns_[band] = 0;
      }
      turns_[reached_.end] = 0;
      reached_ = kNone;
    }

    std::span<Group> groups_;
    size_t polygon_;
    BandRange reached_ = kNone;
    std::array<uint64_t, kMostBands + 1> turns_{};  // bits in which a band differs from the last
  };

  // Those that reach one of these bands, in order, from one on.
  class Walk {
   public:
    static constexpr size_t kEnd = SIZE_MAX;

    Walk(const BandIndex& index, BandRange bands, size_t first)
        : groups_(index.groups_), bands_(bands), group_(first / kPolygonsPerGroup) {
      if (group_ < groups_.size())
        bits_ = bits_of(group_) & ~uint64_t{0} << first % kPolygonsPerGroup;
    }

    [[nodiscard]] size_t next() {
      while (bits_ == 0) {
        if (group_ + 1 >= groups_.size()) return kEnd;
        bits_ = bits_of(++group_);
      }
      const auto bit = static_cast<size_t>(std::countr_zero(bits_));
      bits_ &= bits_ - 1;
      return group_ * kPolygonsPerGroup + bit;
    }

   private:
    [[nodiscard]] uint64_t bits_of(size_t at) const {
      const Group& group = groups_[at];
      const BandRange seen = bands_.within(group.reached);
      uint64_t bits = 0;
      for (size_t band = seen.first; band < seen.end; ++band) bits |= group.words[band];
      return bits;
    }

    std::span<const Group> groups_;
    BandRange bands_;
    size_t group_;       // the one that bits_ are of
    uint64_t bits_ = 0;  // of those that are still to be told
  };

 private:
  Bands bands_;
  std::span<Group> groups_;
};

}  // namespace selvage::many
