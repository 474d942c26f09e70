#include "reports/bench/report.h"

#include <algorithm>

#include "cli/status_line.h"
#include "reports/bench/error_count.h"
#include "reports/bench/machine.h"
#include "reports/bench/spans.h"
#include "reports/bench/statistics.h"

namespace selvage::reports {

namespace {

using Json = nlohmann::ordered_json;

struct Entry {
  const Subject* subject = nullptr;
  std::string refusal;
  ErrorCount errors;
  std::function<void()> draw;  // empty where refused
};

struct Prepared {
  Workload load;
  Texture texture;
  uint64_t covered_px = 0;
  std::vector<Entry> entries;
};

uint64_t count_covered(const Workload& load) {
  uint64_t count = 0;
  for (const auto& polygon : load.polygons) {
    for_each_span(polygon, load.target_side_px, load.target_side_px, [&](const Span& span) {
      count += static_cast<uint64_t>(span.right_px - span.left_px);
    });
  }
  return count;
}

void demand_right(const Workload& load, const Subject& subject, const ErrorCount& errors) {
  if (!subject.reference || errors.total() == 0) return;
  throw WrongAnswer(load.id + ": " + subject.title + " differs from the exact model on " +
                    std::to_string(errors.judged_px) +
                    " pixels judged: " + std::to_string(errors.wrong_texels) + " wrong texels, " +
                    std::to_string(errors.missing_px) + " missing, " +
                    std::to_string(errors.extra_px) + " extra. Nothing was timed.");
}

// Judges every subject's drawing of the workload and leaves the drawings ready to be timed.
void judge(Prepared& prepared, const ModelRows& model, const std::vector<Subject>& subjects,
           Target& target) {
  for (const Subject& subject : subjects) {
    Entry entry;
    entry.subject = &subject;
    entry.refusal = subject.refusal(prepared.load);
    if (entry.refusal.empty()) {
      std::fill(target.pixels.begin(), target.pixels.end(), kUntouched);
      entry.draw = subject.prepare(prepared.load, prepared.texture, target);
      entry.draw();
      entry.errors = count_errors(model, target, subject.textures, subject.carried_bits);
      demand_right(prepared.load, subject, entry.errors);
    }
    prepared.entries.push_back(std::move(entry));
  }
}

std::vector<Prepared> prepare_all(const BenchOptions& options, const std::vector<Subject>& subjects,
                                  Target& target, const cli::Console& console) {
  std::vector<Prepared> all;
  for (Workload& load : workloads(options.seed)) {
    const int32_t side = load.texture_side_texel;
    all.push_back({std::move(load), Texture(side), 0, {}});
  }
  size_t rows_done = 0;
  cli::StatusLine line(console);
  const size_t rows_all = all.size() * static_cast<size_t>(options.rows);
  for (Prepared& prepared : all) {  // from here on no Prepared moves: drawings point into them
    const auto rows = sample_rows(target.height_px, options.rows, options.seed);
    const ModelRows model = model_rows(
        prepared.load, rows, [&] { line.count("checking answers: row", ++rows_done, rows_all); });
    prepared.covered_px = count_covered(prepared.load);
    judge(prepared, model, subjects, target);
  }
  return all;
}

std::vector<Spread> time_all(const BenchOptions& options, const std::vector<Prepared>& all,
                             const cli::Console& console) {
  std::vector<Timed> timed;
  std::vector<double> covered_px;
  for (const Prepared& prepared : all) {
    for (const Entry& entry : prepared.entries) {
      if (!entry.draw) continue;
      timed.push_back({prepared.load.id + " " + entry.subject->id, entry.draw});
      covered_px.push_back(static_cast<double>(prepared.covered_px));
    }
  }
  // Before its repetitions a drawing is run a few times more, to find out how often to repeat it.
  size_t runs = 0;
  cli::StatusLine line(console);
  const std::string all_runs =
      std::to_string(timed.size() * static_cast<size_t>(options.timing.repetitions + 4));
  auto times_ns = measure_ns(timed, options.timing, [&] {
    line.show("measuring: run " + std::to_string(++runs) + " of about " + all_runs);
  });
  std::vector<Spread> spreads;
  for (size_t i = 0; i < timed.size(); ++i) {
    for (double& ns : times_ns[i]) ns /= covered_px[i];
    spreads.push_back(spread_of(times_ns[i]));
  }
  return spreads;
}

Json describe(const Entry& entry) {
  if (!entry.draw) return {{"id", entry.subject->id}, {"refusal", entry.refusal}};
  return {{"id", entry.subject->id},
          {"judged_px", entry.errors.judged_px},
          {"covered_px", entry.errors.covered_px},
          {"wrong_texels", entry.subject->textures ? Json(entry.errors.wrong_texels) : Json()},
          {"missing_px", entry.errors.missing_px},
          {"extra_px", entry.errors.extra_px}};
}

// Adds the times, and their ratios to the median of the last subject that was timed: the fill.
Json describe(const Prepared& prepared, const Spread*& spread) {
  Json rows = Json::array();
  for (const Entry& entry : prepared.entries) {
    Json row = describe(entry);
    if (entry.draw) {
      row["ns_per_px"] = {{"median", spread->median},
                          {"lower_quartile", spread->lower_quartile},
                          {"upper_quartile", spread->upper_quartile}};
      ++spread;
    }
    rows.push_back(std::move(row));
  }
  const double fill = rows.back().at("ns_per_px").at("median").get<double>();
  for (Json& row : rows) {
    if (!row.contains("ns_per_px")) continue;
    row["ratio_to_fill"] = row["ns_per_px"]["median"].get<double>() / fill;
  }
  const Workload& load = prepared.load;
  return {{"id", load.id},
          {"title", load.title},
          {"description", load.description},
          {"polygons", load.polygons.size()},
          {"target_px",
           std::to_string(load.target_side_px) + " x " + std::to_string(load.target_side_px)},
          {"covered_px", prepared.covered_px},
          {"results", std::move(rows)}};
}

}  // namespace

nlohmann::ordered_json run_benchmark(const BenchOptions& options,
                                     const std::vector<Subject>& subjects,
                                     const cli::Console& console) {
  constexpr int32_t side_px = 1024;
  Target target(side_px, side_px);
  const std::vector<Prepared> all = prepare_all(options, subjects, target, console);
  const std::vector<Spread> spreads = time_all(options, all, console);
  Json document{{"machine", describe_machine()},
                {"seed", options.seed},
                {"rows", options.rows},
                {"repetitions", options.timing.repetitions},
                {"min_time_s", options.timing.min_time_s}};
  for (const Subject& subject : subjects) {
    document["subjects"].push_back(
        {{"id", subject.id}, {"title", subject.title}, {"configuration", subject.configuration}});
  }
  const Spread* spread = spreads.data();
  for (const Prepared& prepared : all) document["workloads"].push_back(describe(prepared, spread));
  return document;
}

}  // namespace selvage::reports
