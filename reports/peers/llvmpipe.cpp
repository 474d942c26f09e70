// Mesa's llvmpipe through OSMesa: OpenGL drawn by the CPU into the target's memory.
#include <GL/gl.h>
#include <GL/osmesa.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "reports/peers/peer.h"

namespace selvage::reports {

namespace {

struct Corner {
  std::array<float, 4> position;  // homogeneous, in px
  std::array<float, 2> texture;   // in textures
};

Corner corner_of(const selvage_vertex& vertex, int32_t first_q, const selvage_texture& texture) {
  const double w = static_cast<double>(first_q) / vertex.q;
  const auto number = [](double value) { return static_cast<float>(value); };
  return {{number(x_px(vertex) * w), number(y_px(vertex) * w), 0, number(w)},
          {number(u_texel(vertex) / texture.width), number(v_texel(vertex) / texture.height)}};
}

GLint texels_of(ptrdiff_t pitch_bytes) { return static_cast<GLint>(pitch_bytes / 4); }

class Context {
 public:
  Context() {
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    setenv("LP_NUM_THREADS", "0", 1);                // rasterise in the calling thread
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);  // no idle thread, no files
    context_ = OSMesaCreateContextExt(OSMESA_RGBA, 0, 0, 0, nullptr);
    if (context_ == nullptr) throw std::runtime_error("OSMesa: no context");
  }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  // The one of this process; it ends with it, for Mesa's own end may come before any other.
  static Context& shared() {
    static Context* const context = new Context;
    return *context;
  }

  // The versions of OpenGL and Mesa, the driver and its LLVM.
  std::string description() {
    Target any(16, 16);
    draw_into(any.image());
    std::string text(reinterpret_cast<const char*>(glGetString(GL_VERSION)));
    text.append(", ").append(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);  // any goes
    target_ = {};
    return text;
  }

  // False, and nothing to do, if this is where it draws already.
  bool draw_into(const selvage_image& target) {
    if (target.pixels == target_.pixels && target.width == target_.width &&
        target.height == target_.height && target.pitch == target_.pitch)
      return false;
    if (OSMesaMakeCurrent(context_, target.pixels, GL_UNSIGNED_BYTE, target.width, target.height) ==
        GL_FALSE)
      throw std::runtime_error("OSMesa: the target was refused");
    OSMesaPixelStore(OSMESA_ROW_LENGTH, texels_of(target.pitch));
    target_ = target;
    glViewport(0, 0, target.width, target.height);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, target.width, 0, target.height, -1, 1);
    glDisable(GL_DITHER);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    return true;
  }

  // OSMesa draws on a picture of its own, which it copies over the target. White is kUntouched.
  static void clear() {
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
  }

  // The target's own pixels instead, to be drawn upon.
  static void load(const selvage_image& target) {
    glDisable(GL_TEXTURE_2D);
    glDisable(GL_SCISSOR_TEST);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, texels_of(target.pitch));
    glRasterPos2i(0, 0);
    glDrawPixels(target.width, target.height, GL_RGBA, GL_UNSIGNED_BYTE, target.pixels);
  }

 private:
  OSMesaContext context_ = nullptr;
  selvage_image target_{};
};

// A texture object.
class Uploaded {
 public:
  explicit Uploaded(const Canvas& canvas) {
    const selvage_texture& texture = canvas.texture;
    const GLint filter = canvas.filter == SELVAGE_FILTER_BILINEAR ? GL_LINEAR : GL_NEAREST;
    const GLint wrap = canvas.address == SELVAGE_ADDRESS_WRAP ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    glGenTextures(1, &name_);
    glBindTexture(GL_TEXTURE_2D, name_);
    for (const GLenum key : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      glTexParameteri(GL_TEXTURE_2D, key, filter);
    for (const GLenum key : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
      glTexParameteri(GL_TEXTURE_2D, key, wrap);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, texels_of(texture.pitch));
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, texture.width, texture.height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, texture.texels);
  }
  ~Uploaded() { glDeleteTextures(1, &name_); }
  Uploaded(const Uploaded&) = delete;
  Uploaded& operator=(const Uploaded&) = delete;
  [[nodiscard]] GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
};

class LlvmpipePainter : public Painter {
 public:
  explicit LlvmpipePainter(const Canvas& canvas)
      : canvas_(canvas), context_(Context::shared()), texture_(uploaded()) {}

  void draw(std::span<const Polygon> polygons) override {
    // Between two drawings others may draw elsewhere.
    if (context_.draw_into(canvas_.target) && canvas_.opaque) Context::clear();
    if (!canvas_.opaque) Context::load(canvas_.target);
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, texture_->name());
    if (canvas_.clip) clip(*canvas_.clip);
    corners_.clear();
    for (const Polygon& polygon : polygons) {
      for (size_t i = 1; i + 1 < polygon.size(); ++i) {
        for (const size_t j : {size_t{0}, i, i + 1})
          corners_.push_back(corner_of(polygon[j], polygon[0].q, canvas_.texture));
      }
    }
    glVertexPointer(4, GL_FLOAT, sizeof(Corner), corners_.data()->position.data());
    glTexCoordPointer(2, GL_FLOAT, sizeof(Corner), corners_.data()->texture.data());
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_.size()));
    glFinish();
  }

 private:
  [[nodiscard]] std::unique_ptr<Uploaded> uploaded() const {
    context_.draw_into(canvas_.target);
    if (canvas_.opaque) Context::clear();
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    const int32_t longest = std::max({canvas_.texture.width, canvas_.texture.height,
                                      canvas_.target.width, canvas_.target.height});
    if (longest > most)
      throw Inexpressible("a side is beyond GL_MAX_TEXTURE_SIZE, the target's limit here too");
    return std::make_unique<Uploaded>(canvas_);
  }

  static void clip(const selvage_rect& rect) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(rect.left, rect.top, width_of(rect), height_of(rect));
  }

  const Canvas canvas_;
  Context& context_;
  std::unique_ptr<Uploaded> texture_;
  std::vector<Corner> corners_;
};

}  // namespace

std::unique_ptr<Painter> paint_with_llvmpipe(const Canvas& canvas) {
  return std::make_unique<LlvmpipePainter>(canvas);
}

Peer peer_llvmpipe() {
  Subject subject;
  subject.id = "llvmpipe";
  subject.title = "Mesa llvmpipe through OSMesa";
  subject.configuration =
      "OSMESA_RGBA into our memory, GL_RGBA8 texture, GL_NEAREST (W5: GL_LINEAR), "
      "GL_CLAMP_TO_EDGE, GL_REPLACE, no "
      "depth, blending or dithering, LP_NUM_THREADS=0 (rasterises in the calling thread); client "
      "arrays filled from the vertices and one glDrawArrays(GL_TRIANGLES) for all polygons, then "
      "glFinish, which copies the whole picture to our memory, all timed; context and texture are "
      "made beforehand";
  subject.bilinear = true;
  subject.refusal = [](const Workload&) { return std::string(); };
  subject.prepare = prepared_by(paint_with_llvmpipe);
  return {subject, Context::shared().description()};
}

}  // namespace selvage::reports
