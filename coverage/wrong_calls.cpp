// Wrong mappers: right of a drawing by itself, and wrong of the call that it is asked by.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "coverage/catalogue.h"
#include "coverage/job.h"
#include "spec/subject.h"

namespace selvage::coverage {
namespace {

// The arguments of a call, to be changed.
struct DrawCall {
  const selvage_image* target;
  std::optional<selvage_rect> clip;
  std::vector<selvage_vertex> vertices;
  selvage_texture texture;
  selvage_options options;
};

// The mapper itself; what may be changed of calls that it takes is changed before it draws.
void add(Catalogue* catalogue, const char* name, const char* killer, const char* bug,
         std::function<void(DrawCall&)> change) {
  spec::Subject subject = spec::built_in();
  subject.draw = [change = std::move(change)](const selvage_image* target, const selvage_rect* clip,
                                              const selvage_vertex* vertices, size_t count,
                                              const selvage_texture* texture,
                                              const selvage_options* options) {
    const selvage_rect nothing{0, 0, 0, 0};
    const selvage_status status = selvage_draw(target, &nothing, vertices, count, texture, options);
    if (status != SELVAGE_OK) return status;
    DrawCall call{target,
                  clip != nullptr ? std::optional(*clip) : std::nullopt,
                  {vertices, vertices + count},
                  *texture,
                  options != nullptr ? *options : selvage_options{}};
    change(call);
    return selvage_draw(call.target, call.clip ? &*call.clip : nullptr, call.vertices.data(),
                        call.vertices.size(), &call.texture, &call.options);
  };
  subject.name = name;
  catalogue->add(killer, bug, std::move(subject));
}

[[nodiscard]] bool same_places(const std::vector<selvage_vertex>& a,
                               const std::vector<selvage_vertex>& b) {
  return std::ranges::equal(a, b, [](const selvage_vertex& one, const selvage_vertex& two) {
    return one.x == two.x && one.y == two.y && one.u == two.u && one.v == two.v;
  });
}

// Keeps the last call's set-up, and knows it again by less than it was made from.
void add_keepers(Catalogue* catalogue) {
  add(catalogue, "keeps_the_tolerance", "SAME",
      "a set-up is known again by everything but the tolerance", [](DrawCall& call) {
        thread_local std::optional<DrawCall> last;
        if (last && same_places(last->vertices, call.vertices) &&
            std::ranges::equal(last->vertices, call.vertices, {}, &selvage_vertex::q,
                               &selvage_vertex::q)) {
          call.options.tolerance = last->options.tolerance;
        }
        last = call;
      });
  add(catalogue, "keeps_q", "SAME", "a set-up is known again by everything but q",
      [](DrawCall& call) {
        thread_local std::optional<DrawCall> last;  // mappers are tried by several threads
        if (last && same_places(last->vertices, call.vertices)) {
          call.vertices = last->vertices;
        }
        last = call;
      });
  add(catalogue, "keeps_the_filter", "SAME", "a set-up is known again by its vertices alone",
      [](DrawCall& call) {
        thread_local std::optional<DrawCall> last;
        if (last && same_places(last->vertices, call.vertices) &&
            last->texture.format == call.texture.format &&
            last->options.profile == call.options.profile) {
          call.options.filter = last->options.filter;
        }
        last = call;
      });
  add(catalogue, "keeps_the_width", "SAME",
      "a set-up is known again by its vertices, with the width of the texture in it",
      [](DrawCall& call) {
        thread_local std::optional<DrawCall> last;
        if (last && same_places(last->vertices, call.vertices)) {
          call.texture.width = std::min(call.texture.width, last->texture.width);
        }
        last = call;
      });
}

// What is kept of a texture in too few bits.
void add_of_textures(Catalogue* catalogue) {
  add(catalogue, "texture_side_of_a_byte", "SAME",
      "of a texture of more than 256 texels both ways the width is kept in a byte",
      [](DrawCall& call) {
        int32_t& width = call.texture.width;
        if (width > 256 && call.texture.height > 256) width = (width - 1) % 256 + 1;
      });
  add(catalogue, "texture_pitch_of_15_bits", "SAME", "a texture's pitch is kept in 15 bits",
      [](DrawCall& call) {
        ptrdiff_t& pitch = call.texture.pitch;
        const auto row = call.texture.width * bytes_per_texel(call.texture.format);
        const bool is_far = pitch >= 1 << 15 && call.texture.layout == SELVAGE_LAYOUT_ROWS;
        if (is_far && pitch % (1 << 15) >= row) pitch %= 1 << 15;
      });
}

void add_of_options(Catalogue* catalogue) {
  add(catalogue, "tolerant_without_weights", "TOLERANCE",
      "within a tolerance bilinear takes one texel", [](DrawCall& call) {
        if (call.options.tolerance > 0 && call.options.filter == SELVAGE_FILTER_BILINEAR) {
          call.options.filter = SELVAGE_FILTER_NEAREST;
        }
      });
  add(catalogue, "sums_lose_a_row", "SAME",
      "of a texture with sums filters but area never see the last row", [](DrawCall& call) {
        const bool has_sums = call.texture.prepared != nullptr;
        if (!has_sums || call.options.filter == SELVAGE_FILTER_AREA || call.texture.height < 2) {
          return;
        }
        call.texture.prepared = nullptr;
        if (call.texture.layout == SELVAGE_LAYOUT_ROWS) --call.texture.height;
      });
}

// Rows from some one on are not drawn.
void draw_above(DrawCall& call, int32_t end_row) {
  selvage_rect visible =
      call.clip.value_or(selvage_rect{0, 0, call.target->width, call.target->height});
  visible.bottom = std::min(visible.bottom, end_row);
  call.clip = visible;
}

// Numbers of pixels and bytes in too few bits.
void add_of_places(Catalogue* catalogue) {
  add(catalogue, "pixels_in_16_bits", "SAME", "the index of a pixel is taken modulo 2^16",
      [](DrawCall& call) { draw_above(call, (1 << 16) / call.target->width); });
  add(catalogue, "pitch_in_16_bits", "SAME", "a pitch of 2^15 bytes or more is not the pitch",
      [](DrawCall& call) {
        if (std::abs(call.target->pitch) >= 1 << 15) draw_above(call, 1);
      });
}

// Whatever is asked, the mapper draws or tells.
void add_answers(Catalogue* catalogue) {
  spec::Subject any_kernel = spec::built_in();
  any_kernel.draw = [](const selvage_image* target, const selvage_rect* clip,
                       const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                       const selvage_options* options) {
    selvage_options known = options != nullptr ? *options : selvage_options{};
    if (known.kernel < 0 || known.kernel > SELVAGE_KERNEL_NEON) known.kernel = 0;
    return selvage_draw(target, clip, vertices, count, texture, &known);
  };
  any_kernel.name = "any_kernel_will_do";
  catalogue->add("TOTAL", "an unknown kernel is taken for the fastest", std::move(any_kernel));

  spec::Subject choosing = spec::built_in();
  choosing.choose = [](const selvage_image* target, const selvage_rect* clip,
                       const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                       const selvage_options* options, selvage_choice* choice) {
    const selvage_status status =
        selvage_choose(target, clip, vertices, count, texture, options, choice);
    if (status != SELVAGE_OK) return status;
    return selvage_draw(target, clip, vertices, count, texture, options);
  };
  choosing.name = "draws_to_choose";
  catalogue->add("TOLERANCE", "asked for its choice it draws", std::move(choosing));

  spec::Subject padding = spec::built_in();
  padding.draw = [](const selvage_image* target, const selvage_rect* clip,
                    const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                    const selvage_options* options) {
    const selvage_status status = selvage_draw(target, clip, vertices, count, texture, options);
    if (status != SELVAGE_OK || options == nullptr || options->tolerance == 0) return status;
    const ptrdiff_t row = target->width * bytes_per_texel(target->format);
    const bool has_padding = target->height > 1 && target->pitch > row;
    if (has_padding) static_cast<char*>(target->pixels)[row] ^= 1;
    return status;
  };
  padding.name = "tolerance_spills";
  catalogue->add("TOLERANCE", "within a tolerance a byte beside the first row changes",
                 std::move(padding));
}

}  // namespace

void add_wrong_calls(Catalogue* catalogue) {
  add_keepers(catalogue);
  add_of_options(catalogue);
  add_of_textures(catalogue);
  add_of_places(catalogue);
  add_answers(catalogue);
}

}  // namespace selvage::coverage
