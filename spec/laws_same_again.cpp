// Law SAME, of what comes before: a drawing is the same after another one that differs from it in
// one thing alone. What a mapper keeps from call to call must know all of what it was made from.
#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "spec/canvas.h"
#include "spec/filter_texture.h"
#include "spec/law_list.h"
#include "spec/law_tools.h"
#include "spec/status_name.h"
#include "spec/texture_memory.h"
#include "spec/wide_rows.h"

namespace selvage::spec {
namespace {

// The arguments of a call whose pointers stay where they are.
struct CallState {
  std::vector<selvage_vertex> vertices;
  selvage_texture texture;
  selvage_options options;
  bool has_clip;
  selvage_rect clip;
  bool is_given;  // the texture's rows are the case's own
};

struct Change {
  const char* what;                          // "its q"
  void (*make)(const Subject&, CallState*);  // leaves alone what the subject does not take
};

void change_q(const Subject& subject, CallState* call) {
  if (!subject.claims.perspective || call->options.profile != SELVAGE_PROFILE_EXACT) return;
  int32_t more = 1;
  for (selvage_vertex& v : call->vertices) v.q = std::max(v.q / 2, more++);
}

void change_filter(const Subject& subject, CallState* call) {
  const bool is_nearest = call->options.filter == SELVAGE_FILTER_NEAREST;
  const bool can_mix = call->texture.format == SELVAGE_RGBA8888 &&
                       call->options.profile == SELVAGE_PROFILE_EXACT &&
                       holds(subject.claims.filters, SELVAGE_FILTER_BILINEAR);
  if (!is_nearest) call->options.filter = SELVAGE_FILTER_NEAREST;
  if (is_nearest && can_mix) call->options.filter = SELVAGE_FILTER_BILINEAR;
}

void change_address(const Subject& subject, CallState* call) {
  const selvage_address other = SELVAGE_ADDRESS_WRAP - call->options.address;
  if (holds(subject.claims.addresses, other)) call->options.address = other;
}

void change_tolerance(const Subject&, CallState* call) {
  call->options.tolerance = 4 * SELVAGE_SUBTEXELS;
}

void change_clip(const Subject& subject, CallState* call) {
  if (!subject.claims.clip) return;
  if (!call->has_clip) call->clip = {1, 1, 2, 2};
  call->has_clip = !call->has_clip;
}

// Fewer columns of the same rows.
void change_width(const Subject& subject, CallState* call) {
  if (!call->is_given || !subject.claims.outside_texels) return;
  call->texture.width = (call->texture.width + 1) / 2;
}

constexpr std::array kChanges = {
    Change{"its q", change_q},
    Change{"its filter", change_filter},
    Change{"its address mode", change_address},
    Change{"its clip rectangle", change_clip},
    Change{"the width of its texture", change_width},
};
constexpr Change kOfTolerance{"its tolerance", change_tolerance};

// What keeps more than the last call is found out where nothing was drawn before; that takes a
// subject long which has much to begin with.
inline constexpr uint32_t kAnewOneIn = 16;

// A case, drawn again and again from the same memory.
class SameCall {
 public:
  SameCall(const Subject& subject, const Case& c)
      : subject_(subject),
        case_(c),
        texture_(subject, c, filter_texture(c), 0xEE),
        call_(right()) {}

  // After a drawing elsewhere, so that nothing is kept of the call itself, and then one with the
  // change, if there is one. What is drawn is over a background of its own.
  [[nodiscard]] Canvas draw(const Change* change) {
    if (subject_.start_anew && case_.choice % kAnewOneIn == 0) subject_.start_anew();
    Canvas target(case_.format, case_.target_width_px, case_.target_height_px, case_.padding_px,
                  case_.flip_target, 0x5A);
    const Canvas blank = target;
    // Whatever these answer: they may be refused.
    call_.vertices = elsewhere();
    static_cast<void>(draw_on(&target));
    if (change != nullptr) {
      call_ = right();
      change->make(subject_, &call_);
      static_cast<void>(draw_on(&target));
    }
    call_ = right();
    target = blank;
    status_ = draw_on(&target);
    return target;
  }
  [[nodiscard]] selvage_status status() const { return status_; }
  [[nodiscard]] bool is_prepared() const { return texture_.status() == SELVAGE_OK; }

 private:
  [[nodiscard]] CallState right() const {
    return {case_.vertices,
            texture_.view(),
            {case_.profile, case_.filter, case_.address, 0, SELVAGE_KERNEL_FASTEST},
            case_.has_clip,
            case_.clip,
            layout_of(subject_, case_) == Layout::kGiven};
  }
  [[nodiscard]] std::vector<selvage_vertex> elsewhere() const {
    for (const int32_t dx_px : {1, -1}) {
      const auto vertices = moved_in_band(subject_.claims, case_, dx_px * SELVAGE_SUBPIXELS, 0);
      if (vertices) return *vertices;
    }
    return case_.vertices;
  }
  [[nodiscard]] selvage_status draw_on(Canvas* target) const {
    if (subject_.begin_case) subject_.begin_case();  // else it would be given memory in turn
    const selvage_image image = target->image();
    return with_shown(case_, [&] {
      return subject_.draw(&image, call_.has_clip ? &call_.clip : nullptr, call_.vertices.data(),
                           call_.vertices.size(), &call_.texture, &call_.options);
    });
  }

  const Subject& subject_;
  const Case& case_;
  TextureMemory texture_;
  CallState call_;
  selvage_status status_ = SELVAGE_OK;
};

[[nodiscard]] Picture picture_of(const Case& c, const Canvas& canvas) {
  Picture picture{c.target_width_px, c.target_height_px};
  for (int32_t y = 0; y < c.target_height_px; ++y) {
    for (int32_t x = 0; x < c.target_width_px; ++x) picture.pixels.push_back(canvas.pixel(x, y));
  }
  return picture;
}

// A case's drawing, and the same again after others.
class DrawnAgain {
 public:
  DrawnAgain(const Subject& subject, const Case& c)
      : by_itself_(drawing_of(subject, "by itself it shows it")), case_(c), call_(subject, c) {
    by_itself_.shows_texels = false;
    if (!call_.is_prepared()) return;  // of which the layouts tell
    wanted_ = picture_of(c, call_.draw(nullptr));
    status_ = call_.status();
  }

  [[nodiscard]] Judgement judge_after(const Change& change) {
    if (!call_.is_prepared()) return {};
    const std::string what =
        std::string("a drawing is the same after one that differs in ") + change.what + " alone";
    const Canvas again = call_.draw(&change);
    const auto blame = [&](std::string allowed, std::string drawn) {
      return violation_of_call("SAME", what, case_, std::move(allowed), std::move(drawn));
    };
    if (call_.status() != status_) {
      return {.violation =
                  blame("status " + status_name(status_), "status " + status_name(call_.status()))};
    }
    Judgement judgement = compare("SAME", what, case_, picture_of(case_, again), by_itself_,
                                  [&](int32_t x, int32_t y) { return must_be(wanted_.at(x, y)); });
    if (judgement.violation || again.guards_are_intact()) return judgement;
    judgement.violation = blame("the bytes beside the pixels as they were", "others");
    return judgement;
  }

 private:
  OtherDrawing by_itself_;
  const Case& case_;
  SameCall call_;
  Picture wanted_{};
  selvage_status status_ = SELVAGE_OK;
};

// What is drawn within a tolerance is drawn otherwise where rows are wide.
[[nodiscard]] Judgement judge_tolerance(const Subject& subject, const Case& c) {
  Choices choices(c.choice);
  const Case wide = within(subject.claims, made_wide(c, choices));
  if (!is_valid(wide)) return {};
  return DrawnAgain(subject, wide).judge_after(kOfTolerance);
}

}  // namespace

// Two of the changes, for each costs two drawings.
Judgement check_same_again(const Subject& subject, const Case& c) {
  constexpr uint32_t kEach = 2;
  const auto number = static_cast<uint32_t>(kChanges.size()) + 1;
  Judgement judgement;
  DrawnAgain drawn(subject, c);
  for (uint32_t i = 0; i < kEach && !judgement.violation; ++i) {
    const uint32_t change = (c.choice + i) % number;
    add(&judgement, change < kChanges.size() ? drawn.judge_after(kChanges[change])
                                             : judge_tolerance(subject, c));
  }
  return judgement;
}

}  // namespace selvage::spec
