#include "pictures.h"

#include <selvage.h>
#include <stdalign.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

enum { kWidth = 96, kHeight = 64, kSide = 32, kPolygons = 24, kPreparedBytes = 65536 };

static alignas(max_align_t) uint32_t pixels[kHeight * kWidth];
static alignas(max_align_t) uint32_t texels[kSide * kSide];
static alignas(SELVAGE_PREPARED_ALIGNMENT) uint8_t prepared[kPreparedBytes];
static alignas(max_align_t) uint8_t scratch[kPolygons * 128 + 4096];
static selvage_vertex corners[kPolygons][4];

typedef struct {
  const char* name;
  selvage_format format;
  selvage_filter filter;
  int32_t largest_q; /* 1: affine */
  int in_one_call, with_sums;
} Picture;

static const Picture kPictures[] = {
    {"affine", SELVAGE_RGBA8888, SELVAGE_FILTER_NEAREST, 1, 0, 0},
    {"perspective", SELVAGE_RGBA8888, SELVAGE_FILTER_NEAREST, 4096, 0, 0},
    {"steep", SELVAGE_RGBA8888, SELVAGE_FILTER_NEAREST, SELVAGE_Q_MAX, 0, 0},
    {"index8", SELVAGE_INDEX8, SELVAGE_FILTER_NEAREST, 4096, 0, 0},
    {"rgb565", SELVAGE_RGB565, SELVAGE_FILTER_NEAREST, 1, 0, 0},
    {"four", SELVAGE_RGBA8888, SELVAGE_FILTER_FOUR, 1, 0, 0},
    {"bilinear", SELVAGE_RGBA8888, SELVAGE_FILTER_BILINEAR, 4096, 0, 0},
    {"area", SELVAGE_RGBA8888, SELVAGE_FILTER_AREA, 4096, 0, 0},
    {"list", SELVAGE_RGBA8888, SELVAGE_FILTER_NEAREST, 4096, 1, 0},
    {"tiles", SELVAGE_RGBA8888, SELVAGE_FILTER_AREA, 1, 1, 1},
};

/* A linear congruence (Knuth's MMIX): its upper bits. */
static uint32_t next_of(uint64_t* state) {
  *state = *state * 6364136223846793005U + 1442695040888963407U;
  return (uint32_t)(*state >> 32);
}
static int32_t in(uint64_t* state, int32_t least, int32_t end) {
  return least + (int32_t)(next_of(state) % (uint32_t)(end - least));
}

/* Quadrilaterals about the target, of which some reach far beyond it. */
static void place_corners(const Picture* picture, uint64_t* state) {
  static const int32_t kAcross[4] = {-1, 1, 1, -1}, kDown[4] = {-1, -1, 1, 1};
  for (int i = 0; i < kPolygons; ++i) {
    const int32_t x = in(state, 0, kWidth * SELVAGE_SUBPIXELS);
    const int32_t y = in(state, 0, kHeight * SELVAGE_SUBPIXELS);
    const int32_t half = in(state, 1, i % 4 == 0 ? 100000 : 6000), lean = in(state, -half, half);
    for (int k = 0; k < 4; ++k) {
      corners[i][k] = (selvage_vertex){.x = x + half * kAcross[k] + lean * kDown[k],
                                       .y = y + half * kDown[k],
                                       .u = in(state, -40 * 65536, 80 * 65536),
                                       .v = in(state, -40 * 65536, 80 * 65536),
                                       .q = in(state, 1, picture->largest_q + 1)};
    }
  }
}

static selvage_status draw_one_by_one(const selvage_image* target, const selvage_texture* texture,
                                      const selvage_options* options) {
  for (int i = 0; i < kPolygons; ++i) {
    const selvage_status status = selvage_draw(target, NULL, corners[i], 4, texture, options);
    if (status != SELVAGE_OK) return status;
  }
  return SELVAGE_OK;
}

static selvage_status draw_in_one_call(const selvage_image* target, const selvage_texture* texture,
                                       const selvage_options* options) {
  selvage_polygon list[kPolygons];
  for (int i = 0; i < kPolygons; ++i) list[i] = (selvage_polygon){corners[i], 4, texture};
  return selvage_draw_many(target, NULL, list, kPolygons, options, 1, scratch, sizeof scratch,
                           NULL);
}

static selvage_status draw(const Picture* picture, uint64_t* state) {
  const ptrdiff_t bytes = (ptrdiff_t)1 << picture->format;
  const selvage_image target = {pixels, kWidth, kHeight, kWidth * bytes, picture->format};
  selvage_texture texture = {
      texels, kSide, kSide, kSide * bytes, picture->format, SELVAGE_LAYOUT_ROWS, NULL};
  selvage_options options = {.filter = picture->filter, .address = SELVAGE_ADDRESS_WRAP};
  memset(pixels, 0, sizeof pixels);
  place_corners(picture, state);
  if (picture->with_sums) {
    const selvage_texture given = texture;
    const selvage_status status =
        selvage_prepare(&given, SELVAGE_LAYOUT_TILES, 1, prepared, sizeof prepared, &texture);
    if (status != SELVAGE_OK) return status;
  }
  return picture->in_one_call ? draw_in_one_call(&target, &texture, &options)
                              : draw_one_by_one(&target, &texture, &options);
}

/* FNV-1a of 32 bits. */
static uint32_t sum_of_pixels(void) {
  const uint8_t* const bytes = (const uint8_t*)pixels;
  uint32_t sum = 2166136261U;
  for (size_t i = 0; i < sizeof pixels; ++i) sum = (sum ^ bytes[i]) * 16777619U;
  return sum;
}

static void tell(const char* name, uint32_t sum, void (*say)(const char* line)) {
  char line[32];
  const size_t length = strlen(name);
  memcpy(line, name, length);
  line[length] = ' ';
  for (size_t i = 0; i < 8; ++i)
    line[length + 1 + i] = "0123456789abcdef"[sum >> (28 - 4 * i) & 15];
  line[length + 9] = '\0';
  say(line);
}

int draw_pictures(void (*say)(const char* line)) {
  uint64_t state = 1;
  for (size_t i = 0; i < kSide * kSide; ++i) texels[i] = next_of(&state);
  for (size_t i = 0; i < sizeof kPictures / sizeof kPictures[0]; ++i) {
    const selvage_status status = draw(&kPictures[i], &state);
    if (status != SELVAGE_OK) {
      say(kPictures[i].name);
      say(selvage_status_text(status));
      return 1;
    }
    tell(kPictures[i].name, sum_of_pixels(), say);
  }
  return 0;
}
