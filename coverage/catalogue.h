// How the catalogue is put together: each wrong mapper is the right recipe with one step changed.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coverage/recipe.h"
#include "coverage/wrong_mappers.h"

namespace selvage::coverage {

class Catalogue {
 public:
  // `spoil` changes one step of the right recipe.
  template <class Spoil>
  void add(std::string_view name, std::string_view killer, std::string_view bug, Spoil spoil) {
    Recipe recipe;
    spoil(recipe);
    mappers_.push_back({name, bug, killer, subject_of(std::string(name), std::move(recipe))});
  }
  [[nodiscard]] std::vector<WrongMapper> take() { return std::move(mappers_); }

 private:
  std::vector<WrongMapper> mappers_;
};

void add_wrong_coverage(Catalogue* catalogue);
void add_wrong_mapping(Catalogue* catalogue);

}  // namespace selvage::coverage
