/* Sends itself the signal that stands for bad memory, without using any. */
#include <signal.h>

#include "right.h"

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  const selvage_status status = draw_right(target, clip, vertices, count, texture, options);
  if (status == SELVAGE_OK) raise(SIGSEGV);
  return status;
}
