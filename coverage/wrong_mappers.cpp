#include "coverage/wrong_mappers.h"

#include <vector>

#include "coverage/catalogue.h"

namespace selvage::coverage {

std::span<const WrongMapper> wrong_mappers() {
  static const std::vector<WrongMapper> mappers = [] {
    Catalogue catalogue;
    add_wrong_coverage(&catalogue);
    add_wrong_mapping(&catalogue);
    add_wrong_filters(&catalogue);
    add_wrong_historic_edges(&catalogue);
    add_wrong_historic_spans(&catalogue);
    add_wrong_historic_walks(&catalogue);
    return catalogue.take();
  }();
  return mappers;
}

spec::Subject right_mapper(selvage_profile profile) {
  const std::string name = "the recipe with nothing wrong";
  if (profile == SELVAGE_PROFILE_EXACT) return subject_of(name, Recipe{});
  return subject_of(name, HistoricRecipe(profile));
}

}  // namespace selvage::coverage
