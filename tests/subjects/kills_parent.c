/* Ends the process that it was forked from, and waits. */
#include <signal.h>
#include <unistd.h>

#include "right.h"

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  const selvage_status status = draw_right(target, clip, vertices, count, texture, options);
  if (status != SELVAGE_OK) return status;
  kill(getppid(), SIGKILL);
  for (;;) pause();
  return status;
}
