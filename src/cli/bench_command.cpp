#include "cli/bench_command.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <regex>

#include "cli/bench_near_ties.h"
#include "cli/bench_report.h"
#include "cli/error.h"
#include "cli/file.h"
#include "cli/number.h"
#include "cli/seeds.h"
#include "cli/status_line.h"
#include "reports/bench/machine.h"

namespace selvage::cli {
namespace {

[[nodiscard]] int32_t whole_number(const std::string& option, const std::string& text,
                                   int32_t least, int32_t most) {
  const std::optional<int32_t> number = parse_integer<int32_t>(text);
  if (!number || *number < least || *number > most) {
    throw UserError(option + ": '" + text + "' is no number from " + std::to_string(least) +
                    " to " + std::to_string(most));
  }
  return *number;
}

[[nodiscard]] reports::BenchSettings settings_of(const BenchOptions& options) {
  reports::BenchSettings settings;
  settings.seed = first_seed(options.seed);
  settings.rows = whole_number("--rows", options.rows, 1, 4096);
  settings.timing.repetitions = whole_number("--repetitions", options.repetitions, 3, 1000);
  const std::optional<double> seconds = parse_double(options.min_time);
  if (!seconds || *seconds < 0.001 || *seconds > 10)
    throw UserError("--min-time: '" + options.min_time + "' is no time from 0.001 to 10 s");
  settings.timing.min_time_s = *seconds;
  settings.padding_px = whole_number("--padding", options.padding, 0, reports::kMostPadding_px);
  return settings;
}

[[nodiscard]] reports::Wanted wanted_by(const std::string& filter) {
  if (filter.empty()) return [](std::string_view, std::string_view) { return true; };
  try {
    return [pattern = std::regex(filter)](std::string_view item, std::string_view subject) {
      return std::regex_search(std::string(item) + "/" + std::string(subject), pattern);
    };
  } catch (const std::regex_error& error) {
    throw UserError("--filter: '" + filter +
                    "' is no regular expression (ECMAScript): " + error.what());
  }
}

[[nodiscard]] reports::Plan plan_of(const BenchOptions& options, uint64_t seed) {
  reports::Plan plan =
      reports::make_plan(seed, {options.curves, options.kernels}, wanted_by(options.filter));
  if (!plan.items.empty()) return plan;
  std::string reasons;
  for (const std::string& sentence : plan.unavailable) reasons += "\nNot there: " + sentence + ".";
  throw UserError("--filter: '" + options.filter +
                  "' is found in no ITEM/SUBJECT; `selvage bench --list` tells what there is" +
                  (options.curves ? "" : ", `--curves` adds the curves") +
                  (options.kernels ? "" : ", `--kernels` one subject for each kernel") + reasons);
}

// What the system tells about itself in files; empty where it does not.
[[nodiscard]] std::string text_of_system(const char* path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored) ? read_text_file(path) : std::string();
}

[[nodiscard]] reports::Machine machine_now() {
  return reports::describe_machine({text_of_system("/proc/cpuinfo"),
                                    text_of_system("/proc/meminfo"),
                                    text_of_system("/etc/os-release")});
}

[[nodiscard]] std::string cpu_of(const BenchReport& report) {
  const auto found =
      std::ranges::find(report.machine, "cpu", &std::pair<std::string, std::string>::first);
  return found == report.machine.end() ? "unknown" : found->second;
}

void put_out(const BenchOptions& options, const BenchReport& report, const Console& console) {
  const std::string text = options.brief ? bench_brief_json(report) : bench_json(report);
  if (!options.output.empty())
    write_file(options.output, {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
  if (options.json) {
    console.out << text;
    return;
  }
  console.out << bench_table(report);
  if (report.comparison) console.out << '\n' << comparison_table(*report.comparison);
}

}  // namespace

int run_plan(const reports::Plan& plan, const BenchOptions& options, const Console& console) {
  BenchReport report;
  report.settings = settings_of(options);
  report.filter = options.filter;
  report.plan = &plan;
  if (!options.output.empty()) check_output(options.output);
  std::optional<Baseline> baseline;
  if (!options.compare.empty())
    baseline = parse_baseline(options.compare, read_text_file(options.compare));
  report.machine = machine_now();
  report.fastest_kernels = reports::fastest_kernels();
  try {
    StatusLine status(console);
    report.results = reports::measure(plan, report.settings,
                                      [&](std::string_view what, uint64_t done, uint64_t total) {
                                        status.count(what, done, total);
                                      });
  } catch (const reports::WrongAnswer& error) {
    console.err << "selvage: " << error.what() << '\n';
    return kExitLawFailed;
  }
  const Conditions conditions{cpu_of(report), report.settings.padding_px};
  if (baseline) report.comparison = compare(report.results, conditions, std::move(*baseline));
  put_out(options, report, console);
  return kExitFine;
}

int run_bench(const BenchOptions& options, const Console& console) {
  if (!options.near_ties.empty()) {
    const int32_t maps = whole_number("--near-ties", options.near_ties, 1, 10000000);
    return run_near_ties(options, {first_seed(options.seed), maps}, machine_now(), console);
  }
  const reports::Plan plan = plan_of(options, settings_of(options).seed);
  if (!options.list) return run_plan(plan, options, console);
  console.out << bench_list(plan);
  return kExitFine;
}

}  // namespace selvage::cli
