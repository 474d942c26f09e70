#include "reports/bench/measurement.h"

#include <algorithm>
#include <map>

#include "reports/bench/double_drawn.h"
#include "reports/bench/spans.h"

namespace selvage::reports {

namespace {

// Exact coordinates are compared in double: u, v < 2^15 are rounded by less than this.
constexpr double kRounding_texel = 1.0 / (1 << 30);

// Images by their sides: workloads share them. They stay where they are, for drawings point to
// them.
struct Images {
  int32_t padding_px;  // of the targets
  std::map<int32_t, Target> targets{};
  std::map<std::pair<int32_t, Texels>, Texture> textures{};

  Target& target(int32_t side_px) {
    return targets.try_emplace(side_px, side_px, side_px, padding_px).first->second;
  }
  const Texture& texture(const Workload& load) {
    const int32_t side = load.texture_side_texel;
    const Texels kind = texels_for(load.filter);
    return textures.try_emplace({side, kind}, side, kind).first->second;
  }
};

struct Drawing {
  Cell* cell;
  std::string name;
  std::function<void()> draw;
  double covered_px;
};

std::string refusal_of(const Subject& subject, const Workload& load) {
  if (load.filter == kBilinear && !subject.bilinear) return "it is not drawn bilinearly here";
  if (load.filter == kArea && !subject.area) return "it is not filtered by area here";
  return subject.refusal(load);
}

bool is_right(const Subject& subject, const ErrorCount& errors) {
  if (subject.tolerance_texel == 0) return errors.total() == 0;
  return errors.total() == errors.wrong_texels &&
         errors.largest_coordinate_texel <= subject.tolerance_texel + kRounding_texel;
}

void demand_right(const Workload& load, const Subject& subject, const ErrorCount& errors) {
  if (!subject.reference || is_right(subject, errors)) return;
  const std::string difference =
      load.filter == SELVAGE_FILTER_NEAREST
          ? std::to_string(errors.wrong_texels) + " texels differ from the exact model's, by " +
                std::to_string(errors.largest_coordinate_texel) + " texel at most; "
          : std::to_string(errors.unequal_colours) + " colours differ from the exact model's, by " +
                std::to_string(errors.largest_level) + " of 255 at most; ";
  throw WrongAnswer(
      load.id + ": '" + subject.id + "' is not what it must be, on " +
      std::to_string(errors.judged_px) + " pixels judged: " + difference +
      std::to_string(errors.missing_px) + " missing, " + std::to_string(errors.extra_px) +
      " extra, " + std::to_string(errors.extra_in_padding_px) +
      " of these in the padding of rows, " + std::to_string(errors.double_px.value_or(0)) +
      " drawn twice. Nothing was timed.");
}

// What the cells of one item are judged by.
struct Judge {
  const Workload& load;
  const Texture& texture;
  Target& target;
  ModelRows model;
  std::vector<Workload> classes;

  [[nodiscard]] ErrorCount judged(const Subject& subject) const {
    std::fill(target.pixels.begin(), target.pixels.end(), kUntouched);
    subject.prepare(load, texture, target)();
    ErrorCount errors =
        count_errors(model, target, subject.textures, load.filter, subject.carried_bits);
    if (load.polygons.size() > 1)
      errors.double_px = count_double(subject, classes, texture, model.rows_px, target);
    return errors;
  }
};

void judge_item(const Item& item, ItemResult& result, Images& images, const BenchSettings& settings,
                const std::function<void()>& row_done, std::vector<Drawing>& drawings) {
  const Workload& load = item.load;
  Target& target = images.target(load.target_side_px);
  const Texture& texture = images.texture(load);
  const Judge judge{
      load, texture, target,
      model_rows(load, sample_rows(target.height_px, settings.rows, settings.seed), row_done),
      apart(load)};
  result.load = &load;
  result.covered_px = count_covered(load);
  result.cells.resize(item.subjects.size());  // and never again: drawings point to them
  for (size_t i = 0; i < item.subjects.size(); ++i) {
    const Subject& subject = item.subjects[i];
    Cell& cell = result.cells[i];
    cell.subject = &subject;
    cell.refusal = refusal_of(subject, load);
    if (!cell.refusal.empty()) continue;
    if (subject.judged) {
      cell.errors = judge.judged(subject);
      demand_right(load, subject, *cell.errors);
    }
    drawings.push_back({&cell, load.id + "/" + subject.id, subject.prepare(load, texture, target),
                        static_cast<double>(result.covered_px)});
  }
}

void time_all(const std::vector<Drawing>& drawings, const TimingOptions& options,
              const Progress& progress) {
  std::vector<Timed> timed;
  for (const Drawing& drawing : drawings)
    timed.push_back({drawing.name, drawing.draw, drawing.cell->subject->threads});
  // Before its repetitions a drawing is run a few times more, to find out how often to repeat it.
  const uint64_t total = timed.size() * static_cast<uint64_t>(options.repetitions + 4);
  uint64_t runs = 0;
  auto times_ns = measure_ns(timed, options,
                             [&] { progress("measuring: run", std::min(++runs, total), total); });
  for (size_t i = 0; i < drawings.size(); ++i) {
    for (double& ns : times_ns[i]) ns /= drawings[i].covered_px;
    drawings[i].cell->ns_per_px = spread_of(times_ns[i]);
  }
}

}  // namespace

const Cell* ItemResult::measured(std::string_view subject_id) const {
  const auto found = std::ranges::find_if(cells, [&](const Cell& cell) {
    return cell.subject->id == subject_id && cell.refusal.empty();
  });
  return found == cells.end() ? nullptr : &*found;
}

std::optional<double> ratio(const Cell* a, const Cell* b) {
  if (a == nullptr || b == nullptr) return std::nullopt;
  return a->ns_per_px.median / b->ns_per_px.median;
}

std::vector<ItemResult> measure(const Plan& plan, const BenchSettings& settings,
                                const Progress& progress) {
  Images images{settings.padding_px};
  std::vector<ItemResult> results(plan.items.size());
  std::vector<Drawing> drawings;
  uint64_t total = 0, done = 0;
  for (const Item& item : plan.items)
    total += static_cast<uint64_t>(std::min(settings.rows, item.load.target_side_px));
  for (size_t i = 0; i < plan.items.size(); ++i) {
    judge_item(
        plan.items[i], results[i], images, settings,
        [&] { progress("checking answers: row", ++done, total); }, drawings);
  }
  time_all(drawings, settings.timing, progress);
  return results;
}

}  // namespace selvage::reports
