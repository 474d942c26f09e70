// Our mapper, through its public call: exact, and within the tolerances that a scene may allow.
#include <array>
#include <stdexcept>

#include "reports/bench/kernels.h"
#include "reports/bench/subject.h"

namespace selvage::reports {

namespace {

Subject subject_with_options(std::string id, std::string title, const selvage_options& chosen) {
  Subject subject;
  subject.id = std::move(id);
  subject.title = std::move(title);
  subject.configuration = "selvage_draw once a polygon, clamp; set-up is timed";
  subject.group = "ours";
  subject.reference = true;
  subject.tolerance_texel = chosen.tolerance / static_cast<double>(SELVAGE_SUBTEXELS);
  subject.bilinear = subject.area = true;
  subject.refusal = [](const Workload&) { return std::string(); };
  subject.prepare = [chosen](const Workload& load, const Texture& texture,
                             Target& target) -> std::function<void()> {
    selvage_options options = chosen;
    options.filter = load.filter;
    return [&load, options, view = texture.view(), image = target.image()] {
      for (const auto& polygon : load.polygons) {
        const selvage_status status =
            selvage_draw(&image, nullptr, polygon.data(), polygon.size(), &view, &options);
        if (status != SELVAGE_OK)
          throw std::runtime_error(load.id + ": selvage_draw: " + selvage_status_text(status));
      }
    };
  };
  return subject;
}

}  // namespace

Subject subject_exact() { return subject_with_options("exact", "Selvage, exact", {}); }

std::vector<Subject> subjects_by_kernel() {
  std::vector<Subject> subjects;
  for (const selvage_kernel kernel : kernels_here()) {
    selvage_options options{};
    options.kernel = kernel;
    const std::string name = kernel_name(kernel);
    subjects.push_back(subject_with_options("kernel-" + name,
                                            "Selvage, exact, by its " + name + " kernel", options));
  }
  return subjects;
}

std::vector<Subject> subjects_tolerant() {
  struct Tolerance {
    const char* texel;
    int32_t fx16;
  };
  constexpr std::array<Tolerance, 4> tolerances{
      {{"1/256", 256}, {"1/16", 4096}, {"1/4", 16384}, {"1", 65536}}};
  std::vector<Subject> subjects;
  for (const Tolerance& tolerance : tolerances) {
    const std::string texel = tolerance.texel;
    selvage_options options{};
    options.tolerance = tolerance.fx16;
    subjects.push_back(
        subject_with_options("tol-" + texel, "Selvage, tolerance " + texel + " texel", options));
  }
  return subjects;
}

bool mapper_takes(selvage_filter filter) {
  const std::array<selvage_vertex, 3> corner{
      {{0, 0, 0, 0, 1}, {256, 0, 65536, 0, 1}, {0, 256, 0, 65536, 1}}};
  const Texture texture(2);
  Target target(1, 1);
  const selvage_image image = target.image();
  const selvage_texture view = texture.view();
  selvage_options options{};
  options.filter = filter;
  return selvage_draw(&image, nullptr, corner.data(), corner.size(), &view, &options) == SELVAGE_OK;
}

}  // namespace selvage::reports
