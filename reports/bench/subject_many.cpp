// Our mapper on a whole workload in one call: what a program with a mesh would call.
#include <cstddef>
#include <memory>
#include <stdexcept>

#include "reports/bench/subject.h"

namespace selvage::reports {

namespace {

// All that one call reads and writes, but for the vertices and the pixels.
struct Call {
  std::string item;
  selvage_image image;
  selvage_texture view;
  selvage_options options{};
  int32_t threads;
  std::vector<selvage_polygon> polygons;  // of this view
  std::vector<std::max_align_t> scratch;

  void operator()() {
    const selvage_status status =
        selvage_draw_many(&image, nullptr, polygons.data(), polygons.size(), &options, threads,
                          scratch.data(), scratch.size() * sizeof(std::max_align_t), nullptr);
    if (status != SELVAGE_OK)
      throw std::runtime_error(item + ": selvage_draw_many: " + selvage_status_text(status));
  }
};

std::shared_ptr<Call> call_for(const Workload& load, const Texture& texture, Target& target,
                               int32_t threads) {
  auto call = std::make_shared<Call>();
  call->item = load.id;
  call->image = target.image();
  call->view = texture.view();
  call->options.filter = load.filter;
  call->threads = threads;
  for (const auto& polygon : load.polygons)
    call->polygons.push_back({polygon.data(), polygon.size(), &call->view});
  call->scratch.resize(selvage_draw_many_bytes(load.polygons.size()) / sizeof(std::max_align_t) +
                       1);
  return call;
}

}  // namespace

Subject subject_exact_many(int32_t threads) {
  Subject subject;
  subject.id = "exact-many";
  subject.title = "Selvage, exact, all polygons in one call";
  subject.configuration =
      "selvage_draw_many once an item, clamp, threads = " + std::to_string(threads) +
      "; set-up is timed; the list of polygons and the scratch memory are made "
      "beforehand";
  subject.group = "ours";
  subject.reference = true;
  subject.bilinear = true;
  subject.area = true;
  subject.threads = threads != 1;
  subject.refusal = [](const Workload&) { return std::string(); };
  subject.prepare = [threads](const Workload& load, const Texture& texture,
                              Target& target) -> std::function<void()> {
    return [call = call_for(load, texture, target, threads)] { (*call)(); };
  };
  return subject;
}

}  // namespace selvage::reports
