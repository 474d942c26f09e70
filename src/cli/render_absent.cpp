#include "cli/error.h"
#include "cli/render_command.h"

namespace selvage::cli {

int run_render(const RenderOptions&, const Console&) {
  throw UserError(
      "this selvage was built without scenes. Install libeigen3-dev and libtinyobjloader-dev (or "
      "what your system calls them), then configure with SELVAGE_SCENES=ON and build again");
}

}  // namespace selvage::cli
