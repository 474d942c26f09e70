/* A mapper that is a program, in whatever language: each call is a line to its standard input, and
 * a line that it answers. The command is that of the environment variable SELVAGE_MAPPER.
 *
 * A call is JSON: {"target": {"width": 2, "height": 1, "format": 2, "pixels": "5a5a..."},
 *   "clip": [left, top, right, bottom] or null, "vertices": [[x, y, u, v, q], ...],
 *   "texture": {"width": 1, "height": 1, "format": 2, "pixels": "..."},
 *   "options": {"profile": 0, "filter": 0, "address": 0, "tolerance": 0, "kernel": 0}}
 * Pixels are hexadecimal, two digits a byte, row by row from the top, nothing between rows; units
 * and values are those of selvage.h. The answer is the status, a blank and the target's pixels as
 * they are then: "0 5a5a...". */
#include <selvage_subject.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

/* What the program promises: see selvage_subject.h. This is what mapper.py does. */
static const selvage_claims claims = {
    .bytes = sizeof(selvage_claims),
    .name = "program",
    .filters = 1u << SELVAGE_FILTER_NEAREST,
    .lacks = SELVAGE_LACKS_NAMED_ERRORS,
    .longest_side_px = 64, /* it takes its time */
    .longest_side_texel = 256,
};

SELVAGE_API const selvage_claims* selvage_subject(void) { return &claims; }

/* The program, and the pipes to it and from it. */
static FILE *to_program, *from_program;

/* The testbed tells of it, and --subject-output FILE has the words. */
static void give_up(const char* why) {
  fprintf(stderr, "bridge: %s\n", why);
  abort();
}

static void start(void) {
  const char* command = getenv("SELVAGE_MAPPER");
  if (command == NULL) give_up("SELVAGE_MAPPER is not set; a command as in a shell is right");
  int calls[2], answers[2];
  if (pipe(calls) != 0 || pipe(answers) != 0) give_up("no pipes");
  const pid_t program = fork();
  if (program < 0) give_up("no process");
  if (program == 0) {
    dup2(calls[0], 0);
    dup2(answers[1], 1);
    for (int i = 0; i < 2; ++i) close(calls[i]), close(answers[i]);
    execl("/bin/sh", "sh", "-c", command, (char*)NULL);
    _exit(127);
  }
  close(calls[0]), close(answers[1]);
  to_program = fdopen(calls[1], "w");
  from_program = fdopen(answers[0], "r");
  if (to_program == NULL || from_program == NULL) give_up("no streams");
}

static int pixel_bytes(selvage_format format) {
  return format == SELVAGE_INDEX8 ? 1 : format == SELVAGE_RGB565 ? 2 : 4;
}

static void send_picture(const char* name, const void* pixels, int32_t width, int32_t height,
                         ptrdiff_t pitch, selvage_format format) {
  fprintf(to_program, "\"%s\": {\"width\": %d, \"height\": %d, \"format\": %d, \"pixels\": \"",
          name, width, height, format);
  static const char digits[] = "0123456789abcdef";
  for (int32_t y = 0; y < height; ++y) {
    const unsigned char* row = (const unsigned char*)pixels + y * pitch;
    for (int32_t i = 0; i < width * pixel_bytes(format); ++i) {
      fputc(digits[row[i] >> 4], to_program);
      fputc(digits[row[i] & 15], to_program);
    }
  }
  fputs("\"}, ", to_program);
}

static void send_call(const selvage_image* target, const selvage_rect* clip,
                      const selvage_vertex* vertices, size_t count, const selvage_texture* texture,
                      const selvage_options* options) {
  fputc('{', to_program);
  send_picture("target", target->pixels, target->width, target->height, target->pitch,
               target->format);
  send_picture("texture", texture->texels, texture->width, texture->height, texture->pitch,
               texture->format);
  fputs("\"vertices\": [", to_program);
  for (size_t i = 0; i < count; ++i) {
    const selvage_vertex* v = &vertices[i];
    fprintf(to_program, "%s[%d, %d, %d, %d, %d]", i > 0 ? ", " : "", v->x, v->y, v->u, v->v, v->q);
  }
  fputs("], \"clip\": ", to_program);
  if (clip == NULL) {
    fputs("null", to_program);
  } else {
    fprintf(to_program, "[%d, %d, %d, %d]", clip->left, clip->top, clip->right, clip->bottom);
  }
  const selvage_options none = {0};
  const selvage_options* o = options != NULL ? options : &none;
  fprintf(to_program,
          ", \"options\": {\"profile\": %d, \"filter\": %d, \"address\": %d, \"tolerance\": %d, "
          "\"kernel\": %d}}\n",
          o->profile, o->filter, o->address, o->tolerance, o->kernel);
  if (fflush(to_program) != 0) give_up("the program reads no more");
}

static unsigned digit(char letter) {
  if (letter >= '0' && letter <= '9') return (unsigned)(letter - '0');
  if (letter >= 'a' && letter <= 'f') return (unsigned)(letter - 'a') + 10;
  give_up("the program answered what is no hexadecimal digit, 0 to 9 or a to f");
  return 0;
}

/* Only what has changed is written. */
static void take_pixels(const char* hex, const selvage_image* target) {
  for (int32_t y = 0; y < target->height; ++y) {
    unsigned char* row = (unsigned char*)target->pixels + y * target->pitch;
    for (int32_t i = 0; i < target->width * pixel_bytes(target->format); ++i, hex += 2) {
      const unsigned high = digit(hex[0]), byte = high << 4 | digit(hex[1]);
      if (row[i] != byte) row[i] = (unsigned char)byte;
    }
  }
  if (*hex != '\n') give_up("the program answered more pixels than the target has");
}

selvage_status selvage_draw(const selvage_image* target, const selvage_rect* clip,
                            const selvage_vertex* vertices, size_t count,
                            const selvage_texture* texture, const selvage_options* options) {
  static char* line;
  static size_t line_bytes;
  if (to_program == NULL) start();
  send_call(target, clip, vertices, count, texture, options);
  if (getline(&line, &line_bytes, from_program) < 0) give_up("the program has ended");
  char* pixels = NULL;
  const selvage_status status = (selvage_status)strtol(line, &pixels, 10);
  if (*pixels != ' ') give_up("the program's answer is not a status, a blank and pixels");
  take_pixels(pixels + 1, target);
  return status;
}
