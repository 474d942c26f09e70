/* Opens files and starts threads that go on, and forgets them. */
#include <pthread.h>
#include <unistd.h>

#include "right.h"

static void* go_on(void* unused) {
  (void)unused;
  for (;;) usleep(1000);
  return NULL;
}

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  const selvage_status status = draw_right(target, clip, vertices, count, texture, options);
  if (status != SELVAGE_OK) return status;
  static int threads;
  pthread_t thread;
  (void)!dup(0);
  if (threads < 3 && pthread_create(&thread, NULL, go_on, NULL) == 0) {
    ++threads;
    pthread_detach(thread);
  }
  return status;
}
