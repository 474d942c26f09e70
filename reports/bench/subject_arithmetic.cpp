// The arithmetics of the stability table, each drawing whole polygons through its draw call.
#include <stdexcept>

#include "reports/bench/subject.h"
#include "reports/stability/arithmetic.h"

namespace selvage::reports {

namespace {

Subject subject_of(const stability::Arithmetic& arithmetic) {
  Subject subject;
  subject.id = arithmetic.name;
  subject.title = "the usual way, " + subject.id;
  subject.configuration = std::string(arithmetic.statement) +
                          "; scalar, a call a polygon, nearest, clamp; set-up is timed";
  subject.group = "usual";
  subject.refusal = [affine_only = arithmetic.affine_only](const Workload& load) {
    return std::string(affine_only && load.perspective ? "it knows no perspective" : "");
  };
  subject.prepare = [draw = arithmetic.draw](const Workload& load, const Texture& texture,
                                             Target& target) {
    return [&load, draw, view = texture.view(), image = target.image()] {
      for (const auto& polygon : load.polygons) {
        if (draw(&image, nullptr, polygon.data(), polygon.size(), &view, nullptr) != SELVAGE_OK)
          throw std::runtime_error(load.id + ": a polygon was refused");
      }
    };
  };
  return subject;
}

}  // namespace

std::vector<Subject> subjects_arithmetic() {
  std::vector<Subject> subjects;
  for (const stability::Arithmetic& arithmetic : stability::arithmetics())
    subjects.push_back(subject_of(arithmetic));
  return subjects;
}

}  // namespace selvage::reports
