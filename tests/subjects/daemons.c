/* Leaves a process behind that has a session of its own and no parent, and prints its number: when
 * it is loaded, or in a call, after which it does what WHAT says. */
#include <signal.h>
#include <stdio.h>
#include <unistd.h>

#include "right.h"

enum { LOADED, RETURNS, CRASHES, ENDS_KEEPER };

static void leave_daemon(void) {
  int told[2];
  char ready = 0;
  if (pipe(told) != 0) return;
  if (fork() == 0) {
    setsid();
    if (fork() != 0) _exit(0);
    char text[32];
    const int length = snprintf(text, sizeof text, "%d\n", (int)getpid());
    const int is_printed = write(STDOUT_FILENO, text, (size_t)length) == length;
    for (int all = 1; all < NSIG; ++all) signal(all, SIG_IGN);
    while (is_printed && write(told[1], &ready, 1) == 1) pause();
    _exit(1);
  }
  close(told[1]); /* nothing comes of a daemon that ends with those of the process before */
  (void)!read(told[0], &ready, 1);
  close(told[0]);
}

__attribute__((constructor)) static void load(void) {
  if (WHAT == LOADED) leave_daemon();
}

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  const selvage_status status = draw_right(target, clip, vertices, count, texture, options);
  if (status != SELVAGE_OK || WHAT == LOADED) return status;
  leave_daemon();
  if (WHAT == CRASHES) raise(SIGSEGV);
  if (WHAT == ENDS_KEEPER) kill(getppid(), SIGKILL), pause();
  return status;
}
