/* Has a name that no terminal and no XML can hold, and a version whose 127th byte is within a
 * character. */
#include "right.h"

#define TEN(text) text text text text text text text text text text

static const selvage_claims claims = {
    .bytes = sizeof(selvage_claims),
    .name = "a\x1b[31m\xff\xfe<&\">\n\x01 b",
    .version = TEN("1234567890") "12345678901234567890" "123456" "\xc3\xa4" "more"};
SELVAGE_API const selvage_claims* selvage_subject(void) { return &claims; }

selvage_status selvage_draw(DRAW_ARGUMENTS) {
  return draw_right(target, clip, vertices, count, texture, options);
}
