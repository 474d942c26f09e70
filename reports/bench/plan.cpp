#include "reports/bench/plan.h"

#include <algorithm>
#include <charconv>

namespace selvage::reports {

namespace {

std::vector<Subject> all_subjects(std::vector<Subject> peers, bool with_kernels) {
  std::vector<Subject> all{subject_exact(), subject_exact_many(1)};
  const auto add = [&](std::vector<Subject> more) {
    for (Subject& subject : more) all.push_back(std::move(subject));
  };
  if (with_kernels) add(subjects_by_kernel());
  add(subjects_tolerant());
  add(subjects_historic());
  add(subjects_arithmetic());
  all.push_back(subject_subdivided());
  all.push_back(subject_inexact());
  if (with_kernels) add(subjects_inexact_by_loop());
  add(std::move(peers));
  all.push_back(subject_memcpy());
  all.push_back(subject_touch());
  all.push_back(subject_fill());
  return all;
}

void add_item(Plan& plan, Workload load, const std::vector<Subject>& subjects,
              const Wanted& wanted) {
  Item item{std::move(load), {}};
  for (const Subject& subject : subjects) {
    if (wanted(item.load.id, subject.id)) item.subjects.push_back(subject);
  }
  if (!item.subjects.empty()) plan.items.push_back(std::move(item));
}

// Short and exact: the xs are whole numbers or powers of two.
std::string number(double x) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, x).ptr};
}

void add_curve(Plan& plan, const Curve& curve, const Wanted& wanted) {
  PlannedCurve planned{curve, {}, {}};
  for (const double x : curve.xs) {
    Workload load = curve.load_at(x);
    load.id = curve.id + "=" + number(x);
    load.title = curve.title;
    load.description = curve.description;
    std::vector<Subject> subjects;
    for (const Series& series : curve.series) {
      subjects.push_back(series.subject_at(x));
      subjects.back().id = series.id;
    }
    const size_t before = plan.items.size();
    add_item(plan, std::move(load), subjects, wanted);
    if (plan.items.size() == before) continue;
    planned.xs.push_back(x);
    planned.items.push_back(before);
  }
  if (!planned.xs.empty()) plan.curves.push_back(std::move(planned));
}

// Near-ties are hard for exact mappers; peers and the historic ones only have errors there.
std::vector<Subject> for_adversarial(const std::vector<Subject>& all) {
  std::vector<Subject> some;
  std::ranges::copy_if(all, std::back_inserter(some), [](const Subject& subject) {
    return subject.group == "ours" || subject.group == "usual" || subject.group == "limits";
  });
  return some;
}

void list_subjects(Plan& plan, const std::vector<Subject>& all) {
  for (const Subject& subject : all) {
    const bool asked = std::ranges::any_of(plan.items, [&](const Item& item) {
      return std::ranges::any_of(item.subjects,
                                 [&](const Subject& one) { return one.id == subject.id; });
    });
    if (asked) plan.subjects.push_back(subject);
  }
}

}  // namespace

Plan make_plan(uint64_t seed, const Extras& extras, const Wanted& wanted) {
  Plan plan;
  Peers found = peers();
  plan.unavailable = std::move(found.absent);
  plan.build_information = std::move(found.build_information);
  const std::vector<Subject> all = all_subjects(std::move(found.subjects), extras.kernels);
  for (Workload& load : workloads(seed)) {
    if (mapper_takes(load.filter)) {
      add_item(plan, std::move(load), all, wanted);
    } else {
      plan.unavailable.push_back(load.id + " (" + load.title +
                                 "): the library refuses its filter, so nothing is measured");
    }
  }
  for (Workload& load : adversarial_workloads())
    add_item(plan, std::move(load), for_adversarial(all), wanted);
  plan.work_items = plan.items.size();
  list_subjects(plan, all);
  if (extras.curves) {
    for (const Curve& curve : curves()) add_curve(plan, curve, wanted);
  }
  return plan;
}

}  // namespace selvage::reports
