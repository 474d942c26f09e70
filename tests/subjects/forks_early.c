/* Forks while it is loaded or described, as WHEN says; the copy goes on as WHAT says. */
#include <unistd.h>

#include "right.h"

enum { LOADED, DESCRIBED };
enum {
  LATE,    /* the copy returns a little later */
  REFUSES, /* and with no claims */
  ALONE,   /* the copy alone returns */
  STAYS    /* the copy never does */
};

static int is_refused = 0;

static void fork_here(void) {
  const pid_t copy = fork();
  if (WHAT == ALONE && copy != 0) _exit(0);
  if (WHAT == ALONE || copy != 0) return;
  while (WHAT == STAYS) pause();
  usleep(50000);
  is_refused = WHAT == REFUSES;
}

__attribute__((constructor)) static void load(void) {
  if (WHEN == LOADED) fork_here();
}

static const selvage_claims claims = {.bytes = sizeof(selvage_claims), .name = "forks early"};
SELVAGE_API const selvage_claims* selvage_subject(void) {
  if (WHEN == DESCRIBED) fork_here();
  return is_refused ? 0 : &claims;
}

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  return draw_right(target, clip, vertices, count, texture, options);
}
