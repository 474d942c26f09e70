// Qt's raster engine: QPainter on a QImage over the target's memory. A quad that carries the whole
// texture is an image drawn through a transform; any other polygon is filled with a texture brush.
#include <QtCore/QtGlobal>
#include <QtGui/QBrush>
#include <QtGui/QImage>
#include <QtGui/QPainter>
#include <QtGui/QTransform>
#include <algorithm>
#include <vector>

#include "reports/peers/map.h"
#include "reports/peers/peer.h"

namespace selvage::reports {

namespace {

// Whether its corners are the texture's.
bool carries_whole_texture(const Polygon& polygon, const selvage_texture& texture) {
  const int32_t u_end = texture.width * SELVAGE_SUBTEXELS;
  const int32_t v_end = texture.height * SELVAGE_SUBTEXELS;
  return polygon.size() == 4 &&
         std::all_of(polygon.begin(), polygon.end(), [&](const selvage_vertex& vertex) {
           return (vertex.u == 0 || vertex.u == u_end) && (vertex.v == 0 || vertex.v == v_end);
         });
}

QTransform texture_to_target(const Polygon& polygon) {
  const Planes planes = map_of(polygon);
  const QTransform target_to_texture(planes.u.dx, planes.v.dx, planes.q.dx,  //
                                     planes.u.dy, planes.v.dy, planes.q.dy,  //
                                     planes.u.origin, planes.v.origin, planes.q.origin);
  bool has_inverse = false;
  const QTransform inverse = target_to_texture.inverted(&has_inverse);
  if (!has_inverse) throw Inexpressible("a brush's transform is the inverse, and there is none");
  return inverse;
}

void fill(QPainter& painter, QBrush& brush, const Polygon& polygon, std::vector<QPointF>& points) {
  points.clear();
  for (const selvage_vertex& vertex : polygon) points.emplace_back(x_px(vertex), y_px(vertex));
  brush.setTransform(texture_to_target(polygon));
  painter.setBrush(brush);
  painter.drawConvexPolygon(points.data(), static_cast<int>(points.size()));
}

class QtPainter : public Painter {
 public:
  explicit QtPainter(const Canvas& canvas)
      : canvas_(canvas),
        format_(canvas.opaque ? QImage::Format_RGB32 : QImage::Format_ARGB32_Premultiplied),
        texture_(static_cast<const uchar*>(canvas.texture.texels), canvas.texture.width,
                 canvas.texture.height, canvas.texture.pitch, format_) {}

  void draw(std::span<const Polygon> polygons) override {
    const selvage_image& target = canvas_.target;
    QImage picture(static_cast<uchar*>(target.pixels), target.width, target.height, target.pitch,
                   format_);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setRenderHint(QPainter::SmoothPixmapTransform,
                          canvas_.filter == SELVAGE_FILTER_BILINEAR);
    painter.setPen(Qt::NoPen);
    if (!canvas_.opaque) painter.setCompositionMode(QPainter::CompositionMode_Source);
    if (canvas_.clip) {
      const selvage_rect& clip = *canvas_.clip;
      painter.setClipRect(QRect(clip.left, clip.top, width_of(clip), height_of(clip)));
    }
    QBrush brush(texture_);
    std::vector<QPointF> points;
    for (const Polygon& polygon : polygons) {
      if (carries_whole_texture(polygon, canvas_.texture)) {
        painter.setTransform(texture_to_target(polygon));
        painter.drawImage(0, 0, texture_);
        painter.resetTransform();
      } else {
        fill(painter, brush, polygon, points);
      }
    }
  }

 private:
  const Canvas canvas_;
  const QImage::Format format_;
  const QImage texture_;
};

}  // namespace

std::unique_ptr<Painter> paint_with_qt(const Canvas& canvas) {
  return std::make_unique<QtPainter>(canvas);
}

Peer peer_qt() {
  Subject subject;
  subject.id = "Qt";
  subject.title = "Qt " QT_VERSION_STR " raster engine";
  subject.configuration =
      "Format_RGB32 to Format_RGB32 over our memory, no antialiasing, SmoothPixmapTransform off "
      "(on for W5), "
      "one thread, no display; a quad with the whole texture: drawImage through a QTransform; any "
      "other polygon: drawConvexPolygon, a call a polygon, with the texture as a QBrush and its "
      "transform; transforms from the vertices and the QPainter are timed";
  subject.bilinear = true;
  subject.refusal = [](const Workload&) { return std::string(); };
  subject.prepare = prepared_by(paint_with_qt);
  return {subject, qVersion()};
}

}  // namespace selvage::reports
