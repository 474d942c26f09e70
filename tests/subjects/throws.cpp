// Throws through the C interface.
#include "selvage.h"

extern "C" SELVAGE_API selvage_status selvage_draw(const selvage_image*, const selvage_rect*,
                                                   const selvage_vertex*, size_t,
                                                   const selvage_texture*, const selvage_options*) {
  throw 1;
}
