// Qt's raster engine: QPainter on a QImage over the target's memory. A quad that carries the whole
// texture is an image drawn through a transform; any other polygon is filled with a texture brush.
#include <QtCore/QtGlobal>
#include <QtGui/QBrush>
#include <QtGui/QImage>
#include <QtGui/QPainter>
#include <QtGui/QTransform>
#include <algorithm>
#include <array>

#include "reports/bench/planes.h"
#include "reports/peers/peer.h"

namespace selvage::reports {

namespace {

using Polygon = std::vector<selvage_vertex>;

QPointF position(const selvage_vertex& vertex) { return {x_px(vertex), y_px(vertex)}; }

QTransform texture_to_target(const Polygon& polygon) {
  const Planes planes = planes_of(polygon);
  const QTransform target_to_texture(planes.u.dx, planes.v.dx, planes.q.dx,  //
                                     planes.u.dy, planes.v.dy, planes.q.dy,  //
                                     planes.u.origin, planes.v.origin, planes.q.origin);
  return target_to_texture.inverted();
}

QTransform affine_to_target(const Polygon& polygon) {
  const Planes planes = planes_of(polygon);
  return QTransform(planes.u.dx, planes.v.dx, planes.u.dy, planes.v.dy, planes.u.origin,
                    planes.v.origin)
      .inverted();
}

void draw_filled(QPainter& painter, QBrush& brush, const Polygon& polygon) {
  std::array<QPointF, 16> points;
  const size_t count = std::min(polygon.size(), points.size());
  for (size_t i = 0; i < count; ++i) points[i] = position(polygon[i]);
  brush.setTransform(affine_to_target(polygon));
  painter.setBrush(brush);
  painter.drawConvexPolygon(points.data(), static_cast<int>(count));
}

std::function<void()> prepare(const Workload& load, const Texture& texture, Target& target) {
  const QImage source(reinterpret_cast<const uchar*>(texture.texels.data()), texture.side_texel,
                      texture.side_texel, static_cast<qsizetype>(texture.pitch_texel) * 4,
                      QImage::Format_RGB32);
  const bool bilinear = load.filter == kBilinear;
  return [&load, &target, source, bilinear] {
    QImage picture(reinterpret_cast<uchar*>(target.pixels.data()), target.width_px,
                   target.height_px, static_cast<qsizetype>(target.width_px) * 4,
                   QImage::Format_RGB32);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, bilinear);
    painter.setPen(Qt::NoPen);
    QBrush brush(source);
    for (const Polygon& polygon : load.polygons) {
      if (polygon.size() == 4) {
        painter.setTransform(texture_to_target(polygon));
        painter.drawImage(0, 0, source);
      } else {
        draw_filled(painter, brush, polygon);
      }
    }
  };
}

}  // namespace

Peer peer_qt() {
  Subject subject;
  subject.id = "Qt";
  subject.title = "Qt's raster engine";
  subject.configuration = "as described above for now";
  subject.bilinear = true;
  subject.refusal = [](const Workload&) { return std::string(); };
  subject.prepare = prepare;
  return {subject, qVersion()};
}

}  // namespace selvage::reports
