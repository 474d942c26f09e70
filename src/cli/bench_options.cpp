#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "cli/bench_command.h"

namespace selvage::cli {
namespace {

constexpr const char* kFooter = R"(Examples:
  selvage bench --list                          what there is to measure
  selvage bench --filter '^W[1-6]/'             the work items, without the adversarial ones
  selvage bench --filter '/(exact|fill)$'       two subjects on everything
  selvage bench --kernels --filter '/(kernel|exact$)'    kernel against kernel
  selvage bench --padding 0 --filter '^W3/'     a mesh on rows at a pitch of 4096 bytes
  selvage bench --compare reports/baseline.json
  selvage bench --curves --json --output bench.json
  selvage bench --near-ties 20000 --seed 7      what an adversary can make of near-ties
  selvage bench --brief --output reports/baseline.json    records that baseline

Each drawing is first held against the exact model on sampled rows, then all are timed, interleaved
at random. Times are in ns per covered pixel, the median and the quartiles: of the processor on one
thread, of the clock for what draws with several.

Exit codes: 0 measured, however slow; 1 a drawing that must be exact, or within its tolerance, is
not, and nothing was timed; 2 wrong use, a file that cannot be read or written, or a build without
Google Benchmark (libbenchmark-dev).)";

}  // namespace

CLI::App* add_bench(CLI::App& program, BenchOptions& options) {
  CLI::App* bench =
      program.add_subcommand("bench", "Measure speed against error, beside other mappers");
  bench
      ->add_option("--filter", options.filter,
                   "Measure only what this regular expression (ECMAScript) is found in: names are "
                   "ITEM/SUBJECT")
      ->type_name("REGEX");
  bench
      ->add_option("--compare", options.compare,
                   "Print the ratios of the times to those of this earlier output")
      ->type_name("FILE");
  bench->add_option("--seed", options.seed, "Moves the meshes and the sampled rows")
      ->type_name("S")
      ->capture_default_str();
  bench->add_option("--rows", options.rows, "Rows of each target held against the exact model")
      ->type_name("N")
      ->capture_default_str();
  bench->add_option("--repetitions", options.repetitions, "Timings of each drawing")
      ->type_name("N")
      ->capture_default_str();
  bench->add_option("--min-time", options.min_time, "Seconds of one timing")
      ->type_name("T")
      ->capture_default_str();
  bench
      ->add_option("--padding", options.padding,
                   "Pixels behind each row of the targets; with 0, rows of 1024 px are 4096 bytes "
                   "apart, so that a column shares one set of the first cache and stores cost more")
      ->type_name("PX")
      ->capture_default_str();
  bench->add_flag(
      "--curves", options.curves,
      "Measure cost against polygon size, texture size, scale, off-screen share and threads too");
  bench->add_flag("--kernels", options.kernels,
                  "Measure each of the mapper's kernels, and each of the loops that 'inexact' is "
                  "the fastest of, that this machine can run too");
  bench->add_option("-o,--output", options.output, "Write the JSON to a file")->type_name("FILE");
  bench->add_flag("--json", options.json, "Print the JSON instead of the tables");
  bench->add_flag("--brief", options.brief, "As JSON, the machine and the medians only");
  bench->add_flag("--list", options.list, "List the items and the subjects instead");
  bench
      ->add_option(
          "--near-ties", options.near_ties,
          "Search N random maps, of the seeds from S on, for near-ties that cost the most: "
          "each is held against the scalar kernel's drawing, then timed beside the same map "
          "moved off them; with --kernels, by each kernel")
      ->type_name("N")
      ->excludes("--filter", "--compare", "--rows", "--repetitions", "--min-time", "--padding",
                 "--curves", "--brief", "--list");
  bench->footer(kFooter);
  return bench;
}

}  // namespace selvage::cli
