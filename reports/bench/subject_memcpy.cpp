// A copy of as many bytes as the covered pixels have: what reading and writing them costs at least.
#include <cstring>
#include <memory>

#include "reports/bench/spans.h"
#include "reports/bench/subject.h"

namespace selvage::reports {

namespace {

struct Buffers {
  std::vector<uint32_t> from, to;
};

}  // namespace

Subject subject_memcpy() {
  Subject subject;
  subject.id = "memcpy";
  subject.title = "memcpy";
  subject.configuration =
      "one std::memcpy of the bytes of the covered pixels, from one block to another";
  subject.group = "limits";
  subject.textures = false;
  subject.judged = false;
  subject.bilinear = true;
  subject.area = true;
  subject.refusal = [](const Workload&) { return std::string(); };
  subject.prepare = [](const Workload& load, const Texture&, Target&) -> std::function<void()> {
    const size_t count = count_covered(load);
    const auto buffers = std::make_shared<Buffers>(
        Buffers{std::vector<uint32_t>(count, 1), std::vector<uint32_t>(count, 2)});
    return [buffers] {
      std::memcpy(buffers->to.data(), buffers->from.data(), buffers->to.size() * sizeof(uint32_t));
    };
  };
  return subject;
}

}  // namespace selvage::reports
