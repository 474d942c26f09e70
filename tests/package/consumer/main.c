/* A program outside the tree, in C11: draws one triangle with the installed library, in both ways.
 */
#include <selvage.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(void) {
  uint8_t pixels[8 * 8] = {0};
  const uint8_t texel = 7;
  const selvage_image target = {pixels, 8, 8, 8, SELVAGE_INDEX8};
  const selvage_texture texture = {&texel, 1, 1, 1, SELVAGE_INDEX8, SELVAGE_LAYOUT_ROWS, NULL};
  selvage_vertex corners[3];
  memset(corners, 0, sizeof corners);
  if (selvage_snap(0, 0, 0, 0, 1, 1, &corners[0]) != SELVAGE_OK) return 1;
  if (selvage_snap(8, 0, 1, 0, 1, 1, &corners[1]) != SELVAGE_OK) return 1;
  if (selvage_snap(0, 8, 0, 1, 1, 1, &corners[2]) != SELVAGE_OK) return 1;
  const selvage_status status = selvage_draw(&target, NULL, corners, 3, &texture, NULL);

  /* Below the diagonal: rows of 7, 6, .. 0 pixels, for a centre on the right edge is not drawn. */
  int drawn = 0;
  for (size_t i = 0; i < sizeof pixels; ++i) drawn += pixels[i] == texel;
  printf("selvage %s: %s, %d pixels\n", selvage_version(), selvage_status_text(status), drawn);
  if (status != SELVAGE_OK || drawn != 28) return 1;

  uint8_t again[sizeof pixels] = {0};
  const selvage_image second = {again, 8, 8, 8, SELVAGE_INDEX8};
  const selvage_polygon polygon = {corners, 3, &texture};
  const size_t bytes = selvage_draw_many_bytes(1);
  void* const scratch = malloc(bytes);
  if (scratch == NULL) return 1;
  const selvage_status many =
      selvage_draw_many(&second, NULL, &polygon, 1, NULL, 0, scratch, bytes, NULL);
  free(scratch);

  selvage_kernel fastest = -1;
  void* const picture = malloc(SELVAGE_FASTEST_KERNEL_BYTES);
  if (picture == NULL) return 1;
  const selvage_status measured =
      selvage_fastest_kernel(SELVAGE_FILTER_NEAREST, SELVAGE_INDEX8, SELVAGE_WORK_LARGE, picture,
                             SELVAGE_FASTEST_KERNEL_BYTES, &fastest);
  free(picture);
  if (measured != SELVAGE_OK || selvage_has_kernel(fastest) != 1) return 1;
  return many == SELVAGE_OK && memcmp(pixels, again, sizeof pixels) == 0 ? 0 : 1;
}
