#include "cli/laws_command.h"

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "cli/error.h"
#include "spec/laws.h"
#include "spec/profiles.h"

namespace selvage::cli {
namespace {

[[nodiscard]] std::string_view standing_name(spec::Standing standing) {
  switch (standing) {
    case spec::Standing::kPromised:
      return "promised";
    case spec::Standing::kNotPromised:
      return "not promised";
    default:
      return "says nothing of it";
  }
}

// What is not promised in full, profile by profile.
void print_standings(const spec::Law& law, const Console& console) {
  for (const spec::Profile& profile : spec::profiles()) {
    const spec::Promise promise = spec::promise(profile.id, law.name);
    if (promise.note.empty()) continue;
    console.out << std::string(10, ' ') << profile.name << ": " << standing_name(promise.standing)
                << ": " << promise.note << '\n';
  }
}

[[nodiscard]] nlohmann::ordered_json standings_json(const spec::Law& law) {
  nlohmann::ordered_json standings = nlohmann::ordered_json::object();
  for (const spec::Profile& profile : spec::profiles()) {
    const spec::Promise promise = spec::promise(profile.id, law.name);
    nlohmann::ordered_json& entry = standings[std::string(profile.name)];
    entry["standing"] = standing_name(promise.standing);
    if (!promise.note.empty()) entry["note"] = promise.note;
  }
  return standings;
}

}  // namespace

int run_laws(bool json, const Console& console) {
  if (!json) {
    for (const spec::Law& law : spec::laws()) {
      const std::string name(law.name);
      console.out << name << std::string(name.size() < 10 ? 10 - name.size() : 1, ' ')
                  << law.statement << '\n';
      print_standings(law, console);
    }
    return kExitFine;
  }
  nlohmann::ordered_json values = nlohmann::ordered_json::array();
  for (const spec::Law& law : spec::laws()) {
    values.push_back(
        {{"law", law.name}, {"statement", law.statement}, {"profiles", standings_json(law)}});
  }
  console.out << values.dump(2) << '\n';
  return kExitFine;
}

}  // namespace selvage::cli
