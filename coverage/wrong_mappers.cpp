#include "coverage/wrong_mappers.h"

#include <vector>

#include "coverage/catalogue.h"

namespace selvage::coverage {

std::span<const WrongMapper> wrong_mappers() {
  static const std::vector<WrongMapper> mappers = [] {
    Catalogue catalogue;
    add_wrong_coverage(&catalogue);
    add_wrong_mapping(&catalogue);
    return catalogue.take();
  }();
  return mappers;
}

spec::Subject right_mapper() { return subject_of("the recipe with nothing wrong", Recipe{}); }

}  // namespace selvage::coverage
