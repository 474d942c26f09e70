// Which polygons reach which bands: a bit for each of both.
//
// A word has the bits of 64 polygons that follow each other. The words of all bands lie side by
// side, so that those of some bands are united while they are read.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "many/bands.h"

namespace selvage::many {

class BandIndex {
 public:
  static constexpr size_t kPolygonsPerWord = 64;

  [[nodiscard]] static constexpr size_t words(size_t polygons) {
    return (polygons + kPolygonsPerWord - 1) / kPolygonsPerWord * kMostBands;
  }

  // `words` must be words(..) for all polygons. Each is written before it is read.
  BandIndex(const Bands& bands, std::span<uint64_t> words) : bands_(bands), words_(words) {}

  [[nodiscard]] const Bands& bands() const { return bands_; }

  // Lists polygons one after another: from a multiple of kPolygonsPerWord on, up to another one or
  // the last of all. Others may list other ones at the same time.
  class Writer {
   public:
    Writer(const BandIndex& index, size_t first)
        : index_(&index), count_(index.bands_.count()), polygon_(first) {}

    // The next one, which reaches these bands.
    void add(BandRange bands) {
      const uint64_t bit = uint64_t{1} << (polygon_ % kPolygonsPerWord);
      for (size_t band = bands.first; band < bands.end; ++band) bits_[band] |= bit;
      if (++polygon_ % kPolygonsPerWord == 0) write_words(polygon_ - 1);
    }
    void end() {
      if (polygon_ % kPolygonsPerWord != 0) write_words(polygon_);
    }

   private:
    void write_words(size_t polygon) {
      const auto words = index_->words_of(polygon / kPolygonsPerWord);
      for (size_t band = 0; band < count_; ++band) {
        words[band] = bits_[band];
        bits_[band] = 0;
      }
    }

    const BandIndex* index_;
    size_t count_, polygon_;
    std::array<uint64_t, kMostBands> bits_{};
  };

  // Calls visit(polygon) for those that reach one of these bands, in order.
  template <class Visit>
  void for_each(BandRange bands, const Visit& visit) const {
    for (size_t word = 0; word < words_.size() / kMostBands; ++word) {
      uint64_t bits = 0;
      for (const uint64_t of_band : words_of(word).subspan(bands.first, bands.count())) {
        bits |= of_band;
      }
      for (; bits != 0; bits &= bits - 1) {
        visit(word * kPolygonsPerWord + static_cast<size_t>(std::countr_zero(bits)));
      }
    }
  }

 private:
  [[nodiscard]] std::span<uint64_t> words_of(size_t word) const {
    return words_.subspan(word * kMostBands, kMostBands);
  }

  Bands bands_;
  std::span<uint64_t> words_;
};

}  // namespace selvage::many
