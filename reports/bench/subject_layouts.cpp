// Our mapper from the same texture in other layouts: rows at a pitch of a power of two, and what
// selvage_prepare makes of them.
#include <cstring>
#include <memory>
#include <stdexcept>

#include "reports/bench/subject.h"

namespace selvage::reports {

namespace {

// A texture and its memory.
struct LaidOut {
  std::vector<char> memory;
  selvage_texture view{};

  // So many bytes of it, aligned.
  char* reserve(size_t bytes) {
    memory.resize(bytes + SELVAGE_PREPARED_ALIGNMENT);
    const auto misaligned = reinterpret_cast<uintptr_t>(memory.data()) % SELVAGE_PREPARED_ALIGNMENT;
    return memory.data() + (SELVAGE_PREPARED_ALIGNMENT - misaligned);
  }
};

using LayOut = std::function<std::shared_ptr<LaidOut>(const Texture&)>;

std::shared_ptr<LaidOut> rows_without_padding(const Texture& texture) {
  auto laid_out = std::make_shared<LaidOut>();
  const auto side = static_cast<size_t>(texture.side_texel);
  const size_t row_bytes = side * sizeof(uint32_t);
  char* const texels = laid_out->reserve(row_bytes * side);
  for (size_t t = 0; t < side; ++t) {
    std::memcpy(texels + t * row_bytes,
                texture.texels.data() + t * static_cast<size_t>(texture.pitch_texel), row_bytes);
  }
  laid_out->view = texture.view();
  laid_out->view.texels = texels;
  laid_out->view.pitch = static_cast<ptrdiff_t>(row_bytes);
  return laid_out;
}

LayOut prepared_in(selvage_layout layout) {
  return [layout](const Texture& texture) {
    auto laid_out = std::make_shared<LaidOut>();
    const selvage_texture source = texture.view();
    const size_t bytes = selvage_prepare_bytes(&source, layout, 0);
    const selvage_status status =
        selvage_prepare(&source, layout, 0, laid_out->reserve(bytes), bytes, &laid_out->view);
    if (status != SELVAGE_OK)
      throw std::runtime_error(std::string("selvage_prepare: ") + selvage_status_text(status));
    return laid_out;
  };
}

Subject subject_laid_out(std::string id, std::string title, LayOut lay_out) {
  Subject subject;
  subject.id = std::move(id);
  subject.title = std::move(title);
  subject.configuration = "selvage_draw once a polygon, clamp; preparing the texture is not timed";
  subject.group = "ours";
  subject.reference = true;
  subject.bilinear = true;
  subject.area = true;
  subject.refusal = [](const Workload&) { return std::string(); };
  subject.prepare = [lay_out = std::move(lay_out)](const Workload& load, const Texture& texture,
                                                   Target& target) -> std::function<void()> {
    selvage_options options{};
    options.filter = load.filter;
    return [&load, options, laid_out = lay_out(texture), image = target.image()] {
      for (const auto& polygon : load.polygons) {
        const selvage_status status = selvage_draw(&image, nullptr, polygon.data(), polygon.size(),
                                                   &laid_out->view, &options);
        if (status != SELVAGE_OK)
          throw std::runtime_error(load.id + ": selvage_draw: " + selvage_status_text(status));
      }
    };
  };
  return subject;
}

}  // namespace

std::vector<Subject> subjects_in_layouts() {
  return {
      subject_laid_out("pow2-rows", "Selvage, rows at a power of two", rows_without_padding),
      subject_laid_out("padded-rows", "Selvage, prepared in rows",
                       prepared_in(SELVAGE_LAYOUT_ROWS)),
      subject_laid_out("tiles", "Selvage, prepared in tiles", prepared_in(SELVAGE_LAYOUT_TILES))};
}

}  // namespace selvage::reports
