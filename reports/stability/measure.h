// The stability table: hard families x arithmetics, each cell measured against the exact model.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reports/stability/contender.h"
#include "reports/stability/reference.h"
#include "spec/hard_cases.h"
#include "spec/picture.h"

namespace selvage::stability {

// A contender's drawing of one or many scenes. Every pixel is covered by the reference, or drawn,
// or both: missing, extra, or compared.
struct Errors {
  uint64_t compared_px = 0, missing_px = 0, extra_px = 0;
  uint64_t wrong_texels = 0;
  int32_t largest_texel = 0;  // texel_error over the compared pixels, and their sum
  uint64_t sum_texel = 0;
  double largest_outline_px = 0;  // from the outline to a centre that is missing or too much, in x
                                  // or in y
  std::optional<double> part_of_bound{};  // the largest measured/bound, where a bound is promised
  uint64_t own_coverage_px = 0;           // there: pixels drawn that the contender's own profile
                                          // does not cover, or not drawn although it does
  uint64_t judged_cases = 0;              // the others it does not claim to draw
  uint64_t refused_cases = 0;             // by an error; what they cover is missing
  bool hung = false;                      // in a call that took all its time
  std::string memory_fault{};             // what no mapper may do, and this one did

  void add(const Errors& more);
  [[nodiscard]] double wrong_share() const;
  [[nodiscard]] double mean_texel() const;
  [[nodiscard]] bool flawless() const;
  [[nodiscard]] bool keeps(Promise promise) const;
};

// The worst case of a cell: a broken promise first, then the largest texel error, then the most
// wrong texels, then the most missing and extra pixels.
struct Worst {
  uint64_t seed = 0;
  Errors errors;
};

struct Cell {
  const Contender* contender = nullptr;
  Errors errors;
  std::optional<Worst> worst;  // empty where no case has an error
};

struct FamilyRow {
  const spec::HardFamily* family = nullptr;
  uint64_t covered_px = 0;
  bool perspective = false;   // in some scene the q differ
  std::vector<Cell> cells{};  // in the order of the contenders
};

// A call that does not end as calls do has drawn nothing, and is a memory fault.
[[nodiscard]] Errors errors_of(const Contender& contender, const Reference& model);

// The drawing that errors_of judges, with its pixels as texels of the scene. Throws what a
// subject's calls throw.
[[nodiscard]] spec::Picture drawing_of(const Contender& contender, const Reference& model);

[[nodiscard]] bool is_worse(const Errors& a, const Errors& b, Promise promise);

// The distance between two texels of a side of that size; in wrap mode the shorter way round.
[[nodiscard]] int32_t texel_distance(int32_t a, int32_t b, int32_t size_texel,
                                     selvage_address address);

// The error of a pixel: the greater of the distances in s and in t.
[[nodiscard]] int32_t texel_error(const spec::Case& scene, const spec::Texel& a,
                                  const spec::Texel& b);

// Measures the scenes of seeds first_seed, first_seed + 1, ...; of a contender that hangs none
// after that. `progress` is called with the number of scenes done; may be empty.
[[nodiscard]] FamilyRow measure(const spec::HardFamily& family,
                                std::span<const Contender> contenders, uint64_t first_seed,
                                uint64_t case_count,
                                const std::function<void(uint64_t)>& progress = {});

}  // namespace selvage::stability
