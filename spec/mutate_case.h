// Cases out of cases: each changed in a few ways, toward the hard places.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "spec/case.h"
#include "spec/random.h"

namespace selvage::spec {

// What mutations are to bring nearer to a tie.
enum class Aim { kEdges, kTexels, kBoth, kNothing };

// Changes the case in place. The profile's demands and the ranges of the vertices are seen to by
// mutate_case; a mutation that finds nothing to change changes nothing.
struct Mutation {
  std::string_view name;
  void (*change)(Random& random, Case& c);
};

[[nodiscard]] std::span<const Mutation> outline_mutations();  // where the vertices lie
[[nodiscard]] std::span<const Mutation> texel_mutations();    // u, v and q
[[nodiscard]] std::span<const Mutation> drawing_mutations();  // sizes, clip, formats, options

// The case changed by one to three mutations, chosen by the aim. It is within the ranges of
// spec/case.h, accepted by its profile, and valid if c is.
[[nodiscard]] Case mutate_case(Random& random, const Case& c, Aim aim);

// By one mutation; c itself where that would not be valid.
[[nodiscard]] Case mutated_by(const Mutation& mutation, Random& random, const Case& c);

}  // namespace selvage::spec
