#include "cli/demo_command.h"
#include "cli/error.h"

namespace selvage::cli {

int run_demo(const DemoOptions&, const Console&) {
  throw UserError(
      "this selvage was built without the demo. Install libsdl2-dev, libeigen3-dev and "
      "libtinyobjloader-dev (or what your system calls them), then configure with SELVAGE_DEMO=ON "
      "and build again");
}

}  // namespace selvage::cli
