/* A textbook mapper, to be replaced by yours: triangles, affine, nearest, RGBA8888, 16.16 stepped
 * along rows. Its coverage is exact and its texels nearly are: the verdict tells the two apart. */
#include <selvage_subject.h>

/* What it promises. Each field that is left out claims everything: see selvage_subject.h. */
static const selvage_claims claims = {
    .bytes = sizeof(selvage_claims),
    .name = "textbook",
    .version = "1",
    .formats = 1u << SELVAGE_RGBA8888,
    .filters = 1u << SELVAGE_FILTER_NEAREST,
    .addresses = 1u << SELVAGE_ADDRESS_CLAMP,
    .lacks = SELVAGE_LACKS_PERSPECTIVE | SELVAGE_LACKS_NAMED_ERRORS,
    .most_vertices = 3,
};

SELVAGE_API const selvage_claims* selvage_subject(void) { return &claims; }

/* Twice the area of a, b and (x, y): positive where they run clockwise on the screen. */
static int64_t area(const selvage_vertex* a, const selvage_vertex* b, int64_t x, int64_t y) {
  return ((int64_t)b->x - a->x) * (y - a->y) - ((int64_t)b->y - a->y) * (x - a->x);
}

/* Inside, or on an edge that is a top or a left one. */
static int covers(const selvage_vertex* a, const selvage_vertex* b, int64_t x, int64_t y) {
  const int64_t side = area(a, b, x, y);
  return side > 0 || (side == 0 && (b->y < a->y || (b->y == a->y && b->x > a->x)));
}

static int32_t least(int32_t a, int32_t b) { return a < b ? a : b; }
static int32_t most(int32_t a, int32_t b) { return a > b ? a : b; }

/* To 16.16; what is far beyond any texture is cut, so that steps cannot overflow. */
static int64_t fixed(double value) {
  const double end = 1099511627776.0; /* 2^40 */
  return (int64_t)(value < -end ? -end : value > end ? end : value);
}

static int32_t clamped(int64_t coordinate_fx16, int32_t size) {
  const int64_t texel = coordinate_fx16 >> 16;
  return texel < 0 ? 0 : texel >= size ? size - 1 : (int32_t)texel;
}

/* A coordinate's plane over the triangle: its value at (x, y), and its step along a row. */
typedef struct {
  double at, along_x, along_y;
} plane;

static plane plane_of(const selvage_vertex v[3], const int32_t value[3], double doubled_area) {
  const double d1 = (double)value[1] - value[0], d2 = (double)value[2] - value[0];
  const double x1 = (double)v[1].x - v[0].x, y1 = (double)v[1].y - v[0].y;
  const double x2 = (double)v[2].x - v[0].x, y2 = (double)v[2].y - v[0].y;
  const plane p = {value[0], (d1 * y2 - d2 * y1) / doubled_area,
                   (d2 * x1 - d1 * x2) / doubled_area};
  return p;
}

static double value_at(const plane* p, const selvage_vertex* origin, int64_t x, int64_t y) {
  return p->at + p->along_x * (double)(x - origin->x) + p->along_y * (double)(y - origin->y);
}

selvage_status selvage_draw(const selvage_image* target, const selvage_rect* clip,
                            const selvage_vertex* vertices, size_t count,
                            const selvage_texture* texture, const selvage_options* options) {
  (void)count, (void)options; /* always 3, and what is claimed */
  selvage_vertex v[3] = {vertices[0], vertices[1], vertices[2]};
  int64_t doubled = area(&v[0], &v[1], v[2].x, v[2].y);
  if (doubled == 0) return SELVAGE_OK;
  if (doubled < 0) { /* the other winding, turned round */
    const selvage_vertex swapped = v[1];
    v[1] = v[2];
    v[2] = swapped;
    doubled = -doubled;
  }
  selvage_rect box = {0, 0, target->width, target->height};
  if (clip != NULL) {
    box.left = most(box.left, clip->left), box.right = least(box.right, clip->right);
    box.top = most(box.top, clip->top), box.bottom = least(box.bottom, clip->bottom);
  }
  const int32_t us[3] = {v[0].u, v[1].u, v[2].u}, vs[3] = {v[0].v, v[1].v, v[2].v};
  const plane u_plane = plane_of(v, us, (double)doubled),
              v_plane = plane_of(v, vs, (double)doubled);
  for (int32_t y = box.top; y < box.bottom; ++y) {
    uint32_t* row = (uint32_t*)((char*)target->pixels + y * target->pitch);
    const int64_t centre_y = (int64_t)y * SELVAGE_SUBPIXELS + SELVAGE_SUBPIXELS / 2;
    const int64_t half = SELVAGE_SUBPIXELS / 2;
    int64_t u = fixed(value_at(&u_plane, &v[0], half, centre_y)); /* of column 0 */
    int64_t w = fixed(value_at(&v_plane, &v[0], half, centre_y));
    const int64_t u_step = fixed(u_plane.along_x * SELVAGE_SUBPIXELS);
    const int64_t w_step = fixed(v_plane.along_x * SELVAGE_SUBPIXELS);
    u += box.left * u_step, w += box.left * w_step;
    for (int32_t x = box.left; x < box.right; ++x, u += u_step, w += w_step) {
      const int64_t centre_x = (int64_t)x * SELVAGE_SUBPIXELS + half;
      if (!covers(&v[0], &v[1], centre_x, centre_y)) continue;
      if (!covers(&v[1], &v[2], centre_x, centre_y)) continue;
      if (!covers(&v[2], &v[0], centre_x, centre_y)) continue;
      const char* texels =
          (const char*)texture->texels + clamped(w, texture->height) * texture->pitch;
      row[x] = ((const uint32_t*)texels)[clamped(u, texture->width)];
    }
  }
  return SELVAGE_OK;
}
