// What is compared: one mapper, one arithmetic, one row of the table.
#pragma once

#include <string_view>
#include <vector>

#include "spec/case.h"
#include "spec/subject.h"

namespace selvage::stability {

enum class Promise {
  kNothing,  // measured only
  kBound,    // texels within the profile's derived bound, by its own conventions, or within the
             // accuracies that are claimed
  kExact     // every pixel of the exact model
};

struct Contender {
  std::string_view name;
  std::string_view statement;
  Promise promise;
  selvage_profile profile;  // whose conventions it draws by
  bool affine_only;
  spec::Subject subject;
};

// The historic profiles of the mapper, the arithmetics, and its exact profile.
[[nodiscard]] std::vector<Contender> contenders(const spec::Subject& mapper);

// A mapper of somebody else's, called "subject".
[[nodiscard]] Contender of_library(const spec::Subject& subject);

// The scene as the contender draws it.
[[nodiscard]] spec::Case in_its_way(const Contender& contender, const spec::Case& scene);
// Whether that is the same scene, but for perspective and format, and for the address mode where
// none shows: else it claims not to draw it.
[[nodiscard]] bool can_draw(const Contender& contender, const spec::Case& scene,
                            bool shows_address);

}  // namespace selvage::stability
