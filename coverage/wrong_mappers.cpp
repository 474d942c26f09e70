#include "coverage/wrong_mappers.h"

#include <vector>

#include "coverage/catalogue.h"
#include "coverage/many_recipe.h"

namespace selvage::coverage {

std::span<const WrongMapper> wrong_mappers() {
  static const std::vector<WrongMapper> mappers = [] {
    Catalogue catalogue;
    add_wrong_coverage(&catalogue);
    add_wrong_mapping(&catalogue);
    add_wrong_filters(&catalogue);
    add_wrong_tolerance(&catalogue);
    add_wrong_layouts(&catalogue);
    add_wrong_many(&catalogue);
    add_wrong_calls(&catalogue);
    add_wrong_historic_edges(&catalogue);
    add_wrong_historic_spans(&catalogue);
    add_wrong_historic_walks(&catalogue);
    return catalogue.take();
  }();
  return mappers;
}

spec::Subject right_mapper(selvage_profile profile) {
  const std::string name = "the recipe with nothing wrong";
  spec::Subject right = profile == SELVAGE_PROFILE_EXACT
                            ? subject_of(name, Recipe{})
                            : subject_of(name, HistoricRecipe(profile));
  right.draw_many = draw_many_by(ManyRecipe{}, right);
  right.prepare = spec::built_in().prepare;
  return right;
}

}  // namespace selvage::coverage
