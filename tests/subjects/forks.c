/* Goes on twice. */
#include <unistd.h>

#include "right.h"

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  const selvage_status status = draw_right(target, clip, vertices, count, texture, options);
  if (status != SELVAGE_OK) return status;
  (void)!fork();
  return status;
}
