/* What the subjects of the tests share: the right mapper, which is in the library behind them. */
#ifndef RIGHT_H
#define RIGHT_H

#include <dlfcn.h>

#include "selvage_subject.h"

#define DRAW_ARGUMENTS                                                                   \
  const selvage_image *target, const selvage_rect *clip, const selvage_vertex *vertices, \
      size_t count, const selvage_texture *texture, const selvage_options *options

typedef selvage_status (*draw_function)(DRAW_ARGUMENTS);

static inline selvage_status draw_right(DRAW_ARGUMENTS) {
  static draw_function next;
  if (next == NULL) *(void**)&next = dlsym(RTLD_NEXT, "selvage_draw");
  return next(target, clip, vertices, count, texture, options);
}

static inline ptrdiff_t pixel_bytes(selvage_format format) {
  return format == SELVAGE_INDEX8 ? 1 : format == SELVAGE_RGB565 ? 2 : 4;
}

/* The first byte of an image's rows in memory, and the one behind the last. */
static inline char* first_byte(const selvage_image* image) {
  return (char*)image->pixels + (image->pitch < 0 ? (image->height - 1) * image->pitch : 0);
}
static inline char* end_byte(const selvage_image* image) {
  return (char*)image->pixels + (image->pitch < 0 ? 0 : (image->height - 1) * image->pitch) +
         image->width * pixel_bytes(image->format);
}

#endif
