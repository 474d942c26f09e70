/* Draws right, and tells what by as the macro WRONG has it. */
#include "right_calls.h"

#define RIGHT 0
#define LOWER_BOUND 1 /* half of the bound that is kept */
#define EXACT 2       /* says that everything is exact, but for filters */
#define CRASHES 3

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  return draw_right(target, clip, vertices, count, texture, options);
}

SELVAGE_API selvage_status selvage_choose(DRAW_ARGUMENTS, selvage_choice* choice) {
  const selvage_status status =
      choose_right(target, clip, vertices, count, texture, options, choice);
  if (status != SELVAGE_OK) return status;
  if (WRONG == LOWER_BOUND) choice->bound /= 2;
  const int is_filter = choice->method == SELVAGE_METHOD_FILTER;
  if (WRONG == EXACT && choice->method != SELVAGE_METHOD_NONE && !is_filter) {
    *choice = (selvage_choice){SELVAGE_METHOD_EXACT_PERSPECTIVE, 0, 0};
  }
  if (WRONG == CRASHES && choice->bound > 0) *(volatile char*)options = 1;
  return status;
}
