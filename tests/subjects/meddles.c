/* Draws right, and changes something of its process, as WHAT says: on being loaded or in a call. */
#include <fcntl.h>
#include <fenv.h>
#include <pthread.h>
#include <setjmp.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include "right.h"

enum {
  CLOSES_FILES,
  CHANGES_FOLDER,
  UNDOES_DEATH,    /* does not want to end with its parent */
  LEAVES_GROUP,    /* nor with its group */
  CATCHES_SIGNALS, /* all that it can */
  BLOCKS_SIGNALS,
  LIMITS_ITSELF,
  IGNORES_CHILDREN, /* on being loaded: then nobody may wait for them */
  RINGS_LOADED,     /* on being loaded, an alarm rings a little later */
  ROUNDS_UP,
  FLUSHES,       /* denormal numbers to zero */
  RINGS,         /* an alarm, a little after the call */
  CRASHES_LATER, /* in a thread */
  LONGJMPS,      /* out of the call, to where it was described */
  UNMAPS,        /* the target */
  EXITS_FORKED,  /* whenever its process is forked */
  HANGS_FORKED
};

static jmp_buf described;
static int is_drawing = 0;

static void do_nothing(int signal) { (void)signal; }
static void ring_in_us(int us) {
  const struct itimerval when = {{0, 0}, {0, us}};
  setitimer(ITIMER_REAL, &when, NULL);
}
static void end_forked(void) {
  while (WHAT == HANGS_FORKED) pause();
  _exit(9);
}
static void* crash(void* unused) {
  usleep(2000);
  raise(SIGSEGV);
  return unused;
}

__attribute__((constructor)) static void load(void) {
  if (WHAT == IGNORES_CHILDREN) signal(SIGCHLD, SIG_IGN);
  if (WHAT == RINGS_LOADED) ring_in_us(20000);
  if (WHAT == EXITS_FORKED || WHAT == HANGS_FORKED) pthread_atfork(NULL, NULL, end_forked);
}

static const selvage_claims claims = {.bytes = sizeof(selvage_claims), .name = "meddles"};
SELVAGE_API const selvage_claims* selvage_subject(void) {
  if (WHAT == LONGJMPS && setjmp(described) != 0) is_drawing = 0;
  return &claims;
}

static void meddle(const selvage_image* target) {
  const struct rlimit none = {0, 0};
  sigset_t all;
  pthread_t thread;
  sigfillset(&all);
  if (WHAT == CLOSES_FILES) close_range(0, ~0U, 0);
  if (WHAT == CHANGES_FOLDER) (void)!chdir("/");
  if (WHAT == UNDOES_DEATH) prctl(PR_SET_PDEATHSIG, 0);
  if (WHAT == LEAVES_GROUP) setsid(), setpgid(0, getppid());
  for (int i = 1; WHAT == CATCHES_SIGNALS && i < NSIG; ++i) signal(i, do_nothing);
  if (WHAT == BLOCKS_SIGNALS) sigprocmask(SIG_BLOCK, &all, NULL);
  if (WHAT == LIMITS_ITSELF) setrlimit(RLIMIT_NPROC, &none), setrlimit(RLIMIT_NOFILE, &none);
  if (WHAT == ROUNDS_UP) fesetround(FE_UPWARD);
#if defined(__SSE__)
  if (WHAT == FLUSHES) __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() | 0x8040);
#else
  if (WHAT == FLUSHES) fesetround(FE_DOWNWARD); /* not all machines can */
#endif
  if (WHAT == RINGS) ring_in_us(1);
  if (WHAT == CRASHES_LATER) pthread_create(&thread, NULL, crash, NULL);
  if (WHAT == LONGJMPS && !is_drawing) is_drawing = 1, longjmp(described, 1);
  if (WHAT == UNMAPS) munmap((void*)((uintptr_t)target->pixels & ~(uintptr_t)4095), 4096);
}

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  const selvage_status status = draw_right(target, clip, vertices, count, texture, options);
  if (status == SELVAGE_OK) meddle(target);
  return status;
}
