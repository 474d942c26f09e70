/* The right mapper's other calls. */
#ifndef RIGHT_CALLS_H
#define RIGHT_CALLS_H

#include "right.h"

#define MANY_ARGUMENTS                                                                      \
  const selvage_image *target, const selvage_rect *clip, const selvage_polygon *polygons,   \
      size_t polygon_count, const selvage_options *options, int32_t threads, void *scratch, \
      size_t scratch_bytes, size_t *failed
#define PREPARE_ARGUMENTS                                                                \
  const selvage_texture *source, selvage_layout layout, int32_t with_sums, void *memory, \
      size_t bytes, selvage_texture *prepared

static inline void* next_function(const char* name) { return dlsym(RTLD_NEXT, name); }

static inline selvage_status draw_many_right(MANY_ARGUMENTS) {
  selvage_status (*next)(MANY_ARGUMENTS);
  *(void**)&next = next_function("selvage_draw_many");
  return next(target, clip, polygons, polygon_count, options, threads, scratch, scratch_bytes,
              failed);
}

static inline size_t draw_many_bytes_right(size_t polygon_count) {
  size_t (*next)(size_t);
  *(void**)&next = next_function("selvage_draw_many_bytes");
  return next(polygon_count);
}

static inline selvage_status prepare_right(PREPARE_ARGUMENTS) {
  selvage_status (*next)(PREPARE_ARGUMENTS);
  *(void**)&next = next_function("selvage_prepare");
  return next(source, layout, with_sums, memory, bytes, prepared);
}

static inline size_t prepare_bytes_right(const selvage_texture* source, selvage_layout layout,
                                         int32_t with_sums) {
  size_t (*next)(const selvage_texture*, selvage_layout, int32_t);
  *(void**)&next = next_function("selvage_prepare_bytes");
  return next(source, layout, with_sums);
}

static inline selvage_status choose_right(DRAW_ARGUMENTS, selvage_choice* choice) {
  selvage_status (*next)(DRAW_ARGUMENTS, selvage_choice*);
  *(void**)&next = next_function("selvage_choose");
  return next(target, clip, vertices, count, texture, options, choice);
}

#endif
