// Mesa's llvmpipe through OSMesa: OpenGL drawn by the CPU into the target's memory.
#include <GL/gl.h>
#include <GL/osmesa.h>

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

Corner corner_of(const selvage_vertex& vertex, int32_t first_q, int32_t side_texel) {
  const double w = static_cast<double>(first_q) / vertex.q;
  const auto number = [](double value) { return static_cast<float>(value); };
  return {{number(x_px(vertex) * w), number(y_px(vertex) * w), 0, number(w)},
          {number(u_texel(vertex) / side_texel), number(v_texel(vertex) / side_texel)}};
}

class Context {
 public:
  Context() {
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    setenv("LP_NUM_THREADS", "0", 1);                // rasterise in the calling thread
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);  // no idle thread, no files
    context_ = OSMesaCreateContextExt(OSMESA_RGBA, 0, 0, 0, nullptr);
    if (context_ == nullptr) throw std::runtime_error("OSMesa: no context");
  }
  ~Context() { OSMesaDestroyContext(context_); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  // The versions of OpenGL and Mesa, the driver and its LLVM.
  std::string description() {
    Target any(16, 16);
    draw_into(any);
    std::string text(reinterpret_cast<const char*>(glGetString(GL_VERSION)));
    text.append(", ").append(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);  // any goes
    pixels_ = nullptr;
    return text;
  }

  // Does nothing if this is where it draws already.
  void draw_into(Target& target) {
    if (target.pixels.data() == pixels_ && target.width_px == width_px_) return;
    if (OSMesaMakeCurrent(context_, target.pixels.data(), GL_UNSIGNED_BYTE, target.width_px,
                          target.height_px) == GL_FALSE)
      throw std::runtime_error("OSMesa: the target was refused");
    pixels_ = target.pixels.data();
    width_px_ = target.width_px;
    glViewport(0, 0, target.width_px, target.height_px);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, target.width_px, 0, target.height_px, -1, 1);
    glDisable(GL_DITHER);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    clear();
  }

  // OSMesa draws on a picture of its own, which it copies over the target.
  static void clear() {
    glClearColor(1, 1, 1, 1);  // kUntouched
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
  }

 private:
  OSMesaContext context_ = nullptr;
  const void* pixels_ = nullptr;
  int32_t width_px_ = 0;
};

// A texture object; needs the context while it lives.
class Uploaded {
 public:
  Uploaded(std::shared_ptr<Context> context, const Texture& texture, GLint filter)
      : context_(std::move(context)) {
    glGenTextures(1, &name_);
    glBindTexture(GL_TEXTURE_2D, name_);
    for (const GLenum key : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      glTexParameteri(GL_TEXTURE_2D, key, filter);
    for (const GLenum key : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
      glTexParameteri(GL_TEXTURE_2D, key, GL_CLAMP_TO_EDGE);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, texture.pitch_texel);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, texture.side_texel, texture.side_texel, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, texture.texels.data());
  }
  ~Uploaded() { glDeleteTextures(1, &name_); }
  Uploaded(const Uploaded&) = delete;
  Uploaded& operator=(const Uploaded&) = delete;
  [[nodiscard]] GLuint name() const { return name_; }

 private:
  std::shared_ptr<Context> context_;
  GLuint name_ = 0;
};

void draw(const Workload& load, std::vector<Corner>& corners) {
  corners.clear();
  for (const auto& polygon : load.polygons) {
    for (size_t i = 1; i + 1 < polygon.size(); ++i) {
      for (const size_t j : {size_t{0}, i, i + 1})
        corners.push_back(corner_of(polygon[j], polygon[0].q, load.texture_side_texel));
    }
  }
  glVertexPointer(4, GL_FLOAT, sizeof(Corner), corners.data()->position.data());
  glTexCoordPointer(2, GL_FLOAT, sizeof(Corner), corners.data()->texture.data());
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
  glFinish();
}

}  // namespace

Peer peer_llvmpipe() {
  auto context = std::make_shared<Context>();
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
  subject.prepare = [context](const Workload& load, const Texture& texture, Target& target) {
    context->draw_into(target);
    Context::clear();
    const auto uploaded = std::make_shared<Uploaded>(
        context, texture, load.filter == kBilinear ? GL_LINEAR : GL_NEAREST);
    // Between two drawings others may draw elsewhere.
    return [&load, &target, context, uploaded, corners = std::vector<Corner>()]() mutable {
      context->draw_into(target);
      glBindTexture(GL_TEXTURE_2D, uploaded->name());
      draw(load, corners);
    };
  };
  return {subject, context->description()};
}

}  // namespace selvage::reports
