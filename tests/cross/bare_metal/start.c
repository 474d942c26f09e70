/* A Cortex-M without an operating system: where it starts, and how it speaks to the debugger, or to
 * an emulator that plays one (Arm's semihosting). */
#include <stdint.h>

#include "pictures.h"

extern uint32_t stack_end[], data_begin[], data_end[], data_source[], bss_begin[], bss_end[];

enum { kWrite0 = 0x04, kExitExtended = 0x20, kApplicationExit = 0x20026 };

static void semihost(uintptr_t operation, const void* argument) {
  register uintptr_t r0 __asm__("r0") = operation;
  register const void* r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

static void say(const char* line) {
  semihost(kWrite0, line);
  semihost(kWrite0, "\n");
}

static _Noreturn void leave(uint32_t status) {
  const uint32_t reason[2] = {kApplicationExit, status};
  for (;;) semihost(kExitExtended, reason);
}

_Noreturn void start(void) {
  *(volatile uint32_t*)0xE000ED88 |= 0xF00000; /* CPACR: the floating-point unit is on */
  __asm__ volatile("dsb\n\tisb");
  const uint32_t* from = data_source;
  for (uint32_t* to = data_begin; to != data_end;) *to++ = *from++;
  for (uint32_t* to = bss_begin; to != bss_end;) *to++ = 0;
  leave((uint32_t)draw_pictures(say));
}

static void fault(void) {
  say("a fault");
  leave(3);
}

/* What the processor reads first: where the stack begins, and whom it calls. */
__attribute__((section(".vectors"), used)) static const struct {
  uint32_t* stack;
  void (*handlers[15])(void);
} kVectors = {stack_end, {start, fault, fault, fault, fault, fault}};
