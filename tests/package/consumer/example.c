/* One textured triangle as a picture, triangle.ppm: a whole program, to start from.
 *
 *   cc example.c $(pkg-config --cflags --libs selvage) \
 *      -Wl,-rpath,$(pkg-config --variable=libdir selvage) -o example && ./example
 */
#include <selvage.h>
#include <stdint.h>
#include <stdio.h>

enum { kWidth = 256, kHeight = 256, kSide = 64 };

static uint8_t pixels[kHeight][kWidth][4];
static uint8_t texels[kSide][kSide][4];

static void draw_chequers(void) {
  for (int t = 0; t < kSide; ++t) {
    for (int s = 0; s < kSide; ++s) {
      const int is_dark = (s / 8 + t / 8) % 2;
      texels[t][s][0] = (uint8_t)(is_dark ? 40 : 4 * s);
      texels[t][s][1] = (uint8_t)(is_dark ? 60 : 4 * t);
      texels[t][s][2] = (uint8_t)(is_dark ? 90 : 255);
      texels[t][s][3] = 255;
    }
  }
}

/* A corner at (x, y) px that shows the texture at (u, v) texels; w is 1 everywhere. */
static selvage_status corner(double x, double y, double u, double v, selvage_vertex* to) {
  return selvage_snap(x, y, u, v, 1, 1, to);
}

static int write_ppm(const char* name) {
  FILE* const file = fopen(name, "wb");
  if (file == NULL) return -1;
  fprintf(file, "P6 %d %d 255\n", kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) fwrite(pixels[y][x], 1, 3, file);
  }
  const int failed = ferror(file);
  return fclose(file) != 0 || failed ? -1 : 0;
}

int main(void) {
  const selvage_image target = {pixels, kWidth, kHeight, kWidth * 4, SELVAGE_RGBA8888};
  const selvage_texture texture = {
      texels, kSide, kSide, kSide * 4, SELVAGE_RGBA8888, SELVAGE_LAYOUT_ROWS, NULL};
  selvage_vertex corners[3];
  draw_chequers();
  selvage_status status = corner(10, 10, 0, 0, &corners[0]);
  if (status == SELVAGE_OK) status = corner(200.5, 40, 64, 0, &corners[1]);
  if (status == SELVAGE_OK) status = corner(60, 180, 64, 64, &corners[2]);
  if (status == SELVAGE_OK) status = selvage_draw(&target, NULL, corners, 3, &texture, NULL);
  if (status != SELVAGE_OK) {
    fprintf(stderr, "selvage: %s\n", selvage_status_text(status));
    return 1;
  }
  if (write_ppm("triangle.ppm") != 0) {
    perror("triangle.ppm");
    return 1;
  }
  return 0;
}
