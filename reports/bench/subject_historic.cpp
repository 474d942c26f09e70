// The historic profiles, on the workloads as they can take them: vertices moved to whole pixels and
// samples to where they sample, as in the stability table. Their errors are judged against the
// workload as it is, so they include that rounding.
#include <memory>
#include <stdexcept>

#include "reports/bench/subject.h"
#include "spec/profiles.h"

namespace selvage::reports {

namespace {

Workload in_profile(const Workload& load, selvage_profile profile) {
  Workload moved = load;
  for (auto& polygon : moved.polygons) {
    spec::Case scene;
    scene.vertices = polygon;
    polygon = spec::in_profile(scene, profile).vertices;
  }
  return moved;
}

Subject subject_of(const spec::Profile& profile) {
  Subject subject;
  subject.id = std::string(profile.name);
  subject.title = "profile " + subject.id;
  subject.configuration =
      std::string(profile.statement) +
      "; vertices rounded to whole pixels beforehand, which is most of its error; selvage_draw "
      "once a polygon, clamp; set-up is timed";
  subject.group = "historic";
  subject.refusal = [](const Workload& load) {
    return std::string(load.perspective ? "it knows no perspective" : "");
  };
  subject.prepare = [id = profile.id](const Workload& load, const Texture& texture,
                                      Target& target) -> std::function<void()> {
    selvage_options options{};
    options.profile = id;
    const auto moved = std::make_shared<const Workload>(in_profile(load, id));
    return [moved, options, view = texture.view(), image = target.image()] {
      for (const auto& polygon : moved->polygons) {
        const selvage_status status =
            selvage_draw(&image, nullptr, polygon.data(), polygon.size(), &view, &options);
        if (status != SELVAGE_OK)
          throw std::runtime_error(moved->id + ": selvage_draw: " + selvage_status_text(status));
      }
    };
  };
  return subject;
}

}  // namespace

std::vector<Subject> subjects_historic() {
  std::vector<Subject> subjects;
  for (const spec::Profile& profile : spec::profiles()) {
    if (profile.id != SELVAGE_PROFILE_EXACT) subjects.push_back(subject_of(profile));
  }
  return subjects;
}

}  // namespace selvage::reports
