// A subject: anything with the draw call, and maybe one for many polygons. The laws know nothing
// else about it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "selvage.h"
#include "spec/capabilities.h"

namespace selvage::spec {

// As selvage_draw_many, without what is not the laws' affair: scratch memory.
using DrawMany =
    std::function<selvage_status(const selvage_image*, const selvage_rect*, const selvage_polygon*,
                                 size_t, const selvage_options*, int32_t threads, size_t* failed)>;

// selvage_prepare and selvage_prepare_bytes.
struct Prepare {
  std::function<selvage_status(const selvage_texture*, selvage_layout, int32_t with_sums,
                               void* memory, size_t bytes, selvage_texture* prepared)>
      prepare;
  std::function<size_t(const selvage_texture*, selvage_layout, int32_t with_sums)> bytes;
  // Nothing is drawn from what was prepared in this memory any more; may be empty.
  std::function<void(const void* memory)> release{};
};

class Drawings;

struct Subject {
  std::string name;
  std::function<selvage_status(const selvage_image*, const selvage_rect*, const selvage_vertex*,
                               size_t, const selvage_texture*, const selvage_options*)>
      draw;
  selvage_profile profile = SELVAGE_PROFILE_EXACT;  // the one it is held to
  Capabilities claims{};  // filters that it does not claim must get SELVAGE_ERROR_FILTER
  DrawMany draw_many{};   // may be empty: then nothing is said of it
  // Lays textures out anew; without it, every layout of a case is rows as given.
  std::optional<Prepare> prepare{};
  // selvage_choose, if it has it: what it draws is then held to the bounds that it tells.
  std::function<selvage_status(const selvage_image*, const selvage_rect*, const selvage_vertex*,
                               size_t, const selvage_texture*, const selvage_options*,
                               selvage_choice*)>
      choose{};
  // Called before each case that a law is checked on; may be empty. What changes from call to call
  // starts anew, so that a case can be seen again.
  std::function<void()> begin_case{};
  // Forgets all that calls have left behind, as if it had just been loaded; may be empty.
  std::function<void()> start_anew{};
  Drawings* noted_in = nullptr;  // where spec::draw notes its pictures; may be null
};

// Thrown by a subject's draw where a call did not end as calls do: a crash, a hang, memory that was
// not given to it. It is a violation of the law that is being checked.
struct SubjectFailure {
  std::string happened;         // "read the byte after the end of the texture", ...
  bool hung = false;            // and so took all the time that a call has
  std::string call{};           // which call it was, where the case alone does not tell
  std::optional<Case> shown{};  // the drawing, once it is known
};

// Thrown by a drawing that is beyond what the subject claims: nothing was asked of it.
struct NotClaimed {
  std::string what;
};

// Throws NotClaimed where the case is beyond the subject's claims.
void demand_claimed(const Subject& subject, const Case& c);

// Calls `action`; a SubjectFailure that leaves it knows which drawing it was.
template <typename Action>
auto with_shown(const Case& c, Action&& action) {
  try {
    return std::forward<Action>(action)();
  } catch (SubjectFailure& failure) {
    if (!failure.shown) failure.shown = c;
    throw;
  }
}

// The mapper that this program is linked with.
[[nodiscard]] Subject built_in(selvage_profile profile = SELVAGE_PROFILE_EXACT);

// From now on the subject draws by this kernel, unless a call asks for another, and tells what that
// one would draw by.
void take_kernel(selvage_kernel kernel, Subject* subject);

}  // namespace selvage::spec
