#include "cli/stability_command.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "cli/error.h"
#include "cli/file.h"
#include "cli/picture_output.h"
#include "cli/png.h"
#include "cli/seeds.h"
#include "cli/stability_picture.h"
#include "cli/stability_table.h"
#include "cli/status_line.h"

namespace selvage::cli {
namespace {

using stability::Cell;
using stability::Contender;
using stability::FamilyRow;

// The things of these names, each once; all of them if no name is given.
template <class Thing>
[[nodiscard]] std::vector<Thing> chosen(std::span<const Thing> all,
                                        const std::vector<std::string>& names,
                                        const std::string& option, const std::string& kind) {
  std::vector<Thing> picked;
  for (const std::string& name : names) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Thing& thing) { return thing.name == name; });
    if (found == all.end()) {
      std::string known;
      for (const Thing& thing : all) known += " " + std::string(thing.name);
      throw UserError(option + ": no " + kind + " is called '" + name + "'; there are" + known);
    }
    const bool again = std::any_of(picked.begin(), picked.end(),
                                   [&](const Thing& thing) { return thing.name == name; });
    if (!again) picked.push_back(*found);
  }
  return names.empty() ? std::vector<Thing>(all.begin(), all.end()) : picked;
}

[[nodiscard]] FamilyRow measured(const spec::HardFamily& family,
                                 std::span<const Contender> contenders, const StabilityRun& run,
                                 const Console& console) {
  StatusLine status(console);
  return stability::measure(family, contenders, run.seed, run.cases,
                            [&](uint64_t done) { status.count(family.name, done, run.cases); });
}

// The contender, on any scene.
[[nodiscard]] bool is_measured(const StabilityRun& run, const Contender& contender) {
  return std::ranges::any_of(run.families, [&](const FamilyRow& family) {
    return std::ranges::any_of(family.cells, [&](const Cell& cell) {
      return cell.contender->name == contender.name && cell.errors.judged_cases > 0;
    });
  });
}

[[nodiscard]] bool hangs(const FamilyRow& family) {
  return std::ranges::any_of(family.cells, [](const Cell& cell) { return cell.errors.hung; });
}

struct Scene {
  const FamilyRow* family;
  const Cell* cell;
  uint64_t seed;
};

// The worst scene of the run; the very first where none has an error.
[[nodiscard]] Scene worst_scene(const StabilityRun& run) {
  Scene worst{&run.families.front(), &run.families.front().cells.front(), run.seed};
  const stability::Worst* found = nullptr;
  for (const FamilyRow& family : run.families) {
    for (const Cell& cell : family.cells) {
      if (!cell.worst) continue;
      const bool broken = !cell.worst->errors.keeps(cell.contender->promise);
      const bool found_broken =
          found != nullptr && !found->errors.keeps(worst.cell->contender->promise);
      const bool worse =
          found == nullptr || (broken && !found_broken) ||
          (broken == found_broken &&
           stability::is_worse(cell.worst->errors, found->errors, stability::Promise::kNothing));
      if (!worse) continue;
      found = &*cell.worst;
      worst = {&family, &cell, found->seed};
    }
  }
  return worst;
}

void write_picture(const StabilityOptions& options, const StabilityRun& run,
                   const Console& console) {
  const Scene worst = worst_scene(run);
  const Contender& contender = *worst.cell->contender;
  const stability::Reference model = stability::reference(worst.family->family->make(worst.seed));
  try {
    write_file(options.picture, encode_png(stability_picture(contender, model)));
  } catch (const spec::SubjectFailure& failure) {
    console.err << "selvage: no picture: the subject " << failure.happened << '\n';
    return;
  }
  if (options.json) return;
  console.out << "picture: " << options.picture << " (drawn | exact | difference) of "
              << worst.family->family->name << " by " << contender.name << ", seed " << worst.seed
              << '\n';
}

}  // namespace

int run_stability(const StabilityOptions& options, const spec::Subject& mapper,
                  const Console& console) {
  const ChosenSubject judged = choose_subject(options.subject, "", mapper);
  std::vector<Contender> all = stability::contenders(mapper);
  if (judged.host) all.push_back(stability::of_library(judged.subject));
  if (options.list) {
    console.out << (options.json ? stability_list_json(all) : stability_list(all));
    return kExitFine;
  }
  const auto families = chosen(spec::hard_families(), options.families, "--family", "hard family");
  std::vector<std::string> names = options.arithmetics;
  if (judged.host && !names.empty()) names.emplace_back(all.back().name);
  const auto contenders =
      chosen(std::span<const Contender>(all), names, "--arithmetic", "arithmetic");
  StabilityRun run{judged.subject.name,
                   first_seed(options.seed),
                   case_count(options.cases),
                   {},
                   judged.arguments};
  if (!options.picture.empty()) check_picture(options.picture, PictureKinds::kFiles, console);

  const bool show = !options.json;
  if (show) {
    if (judged.host) console.out << "subject: " << run.subject << '\n';
    console.out << "seed " << run.seed << ", " << run.cases
                << (run.cases == 1 ? " scene" : " scenes") << " of each family\n\n"
                << std::flush;
  }
  std::span<const Contender> left = contenders;
  for (const spec::HardFamily& family : families) {
    run.families.push_back(measured(family, left, run, console));
    // A library, which is the last, takes its time in each scene if it hangs in one.
    if (hangs(run.families.back())) left = left.first(left.size() - 1);
    if (show) console.out << stability_block(run.families.back()) << std::flush;
  }
  console.out << (show ? stability_summary(run) : stability_json(run, contenders));
  const bool is_idle = judged.host && !is_measured(run, all.back());
  if (is_idle) {
    console.err << "selvage: the subject was measured on nothing: it claims to draw no scene\n";
  }
  if (!options.picture.empty()) write_picture(options, run, console);
  return passed(run) && !is_idle ? kExitFine : kExitLawFailed;
}

}  // namespace selvage::cli
