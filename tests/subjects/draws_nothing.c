/* Accepts everything and draws nothing. */
#include "right.h"

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  (void)target, (void)clip, (void)vertices, (void)count, (void)texture, (void)options;
  return SELVAGE_OK;
}
