// How the catalogue is put together: each wrong mapper is the right recipe with one step changed.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coverage/historic_recipe.h"
#include "coverage/recipe.h"
#include "coverage/wrong_mappers.h"
#include "spec/profiles.h"

namespace selvage::coverage {

class Catalogue {
 public:
  // `spoil` changes one step of the right recipe.
  template <class Spoil>
  void add(std::string_view name, std::string_view killer, std::string_view bug, Spoil spoil) {
    Recipe recipe;
    spoil(recipe);
    mappers_.push_back(
        {std::string(name), bug, killer, subject_of(std::string(name), std::move(recipe))});
  }

  // The same bug in each of several historic profiles.
  template <class Spoil>
  void add(std::initializer_list<selvage_profile> profiles, std::string_view name,
           std::string_view killer, std::string_view bug, Spoil spoil) {
    for (const selvage_profile id : profiles) {
      HistoricRecipe recipe(id);
      spoil(recipe);
      const std::string full = std::string(spec::profile_of(id).name) + "_" + std::string(name);
      mappers_.push_back({full, bug, killer, subject_of(full, std::move(recipe))});
    }
  }

  // A mapper that is wrong by itself, by its own name.
  void add(std::string_view killer, std::string_view bug, spec::Subject subject) {
    mappers_.push_back({subject.name, bug, killer, std::move(subject)});
  }

  [[nodiscard]] std::vector<WrongMapper> take() { return std::move(mappers_); }

 private:
  std::vector<WrongMapper> mappers_;
};

inline constexpr selvage_profile k56 = SELVAGE_PROFILE_ABRASH56;
inline constexpr selvage_profile k57 = SELVAGE_PROFILE_ABRASH57;
inline constexpr selvage_profile kDkit = SELVAGE_PROFILE_DKIT;

void add_wrong_coverage(Catalogue* catalogue);
void add_wrong_mapping(Catalogue* catalogue);
void add_wrong_filters(Catalogue* catalogue);
void add_wrong_tolerance(Catalogue* catalogue);
void add_wrong_layouts(Catalogue* catalogue);
void add_wrong_many(Catalogue* catalogue);
void add_wrong_calls(Catalogue* catalogue);
void add_wrong_historic_edges(Catalogue* catalogue);
void add_wrong_historic_spans(Catalogue* catalogue);
void add_wrong_historic_walks(Catalogue* catalogue);

}  // namespace selvage::coverage
