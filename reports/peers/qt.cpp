// Qt's raster engine: QPainter on a QImage over the target's memory. A quad that carries the whole
// texture is an image drawn through a transform; any other polygon is filled with a texture brush.
#include <QtCore/QtGlobal>
#include <QtGui/QBrush>
#include <QtGui/QImage>
#include <QtGui/QPainter>
#include <QtGui/QTransform>
#include <algorithm>
#include <vector>

#include "reports/bench/planes.h"
#include "reports/peers/peer.h"

namespace selvage::reports {

namespace {

using Polygon = std::vector<selvage_vertex>;

// Whether its corners are the texture's.
bool carries_whole_texture(const Polygon& polygon, int32_t side_texel) {
  const int32_t end = side_texel * SELVAGE_SUBTEXELS;
  return polygon.size() == 4 &&
         std::all_of(polygon.begin(), polygon.end(), [&](const selvage_vertex& vertex) {
           return (vertex.u == 0 || vertex.u == end) && (vertex.v == 0 || vertex.v == end);
         });
}

QTransform texture_to_target(const Polygon& polygon) {
  const Planes planes = planes_of(polygon);
  const QTransform target_to_texture(planes.u.dx, planes.v.dx, planes.q.dx,  //
                                     planes.u.dy, planes.v.dy, planes.q.dy,  //
                                     planes.u.origin, planes.v.origin, planes.q.origin);
  return target_to_texture.inverted();
}

void fill(QPainter& painter, QBrush& brush, const Polygon& polygon, std::vector<QPointF>& points) {
  points.clear();
  for (const selvage_vertex& vertex : polygon) points.emplace_back(x_px(vertex), y_px(vertex));
  brush.setTransform(texture_to_target(polygon));
  painter.setBrush(brush);
  painter.drawConvexPolygon(points.data(), static_cast<int>(points.size()));
}

void draw(const Workload& load, const QImage& texture, Target& target) {
  QImage picture(reinterpret_cast<uchar*>(target.pixels.data()), target.width_px, target.height_px,
                 static_cast<qsizetype>(target.width_px) * 4, QImage::Format_RGB32);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setRenderHint(QPainter::SmoothPixmapTransform, load.filter == kBilinear);
  painter.setPen(Qt::NoPen);
  QBrush brush(texture);
  std::vector<QPointF> points;
  for (const Polygon& polygon : load.polygons) {
    if (carries_whole_texture(polygon, load.texture_side_texel)) {
      painter.setTransform(texture_to_target(polygon));
      painter.drawImage(0, 0, texture);
      painter.resetTransform();
    } else {
      fill(painter, brush, polygon, points);
    }
  }
}

std::function<void()> prepare(const Workload& load, const Texture& texture, Target& target) {
  const QImage source(reinterpret_cast<const uchar*>(texture.texels.data()), texture.side_texel,
                      texture.side_texel, static_cast<qsizetype>(texture.pitch_texel) * 4,
                      QImage::Format_RGB32);
  return [&load, &target, source] { draw(load, source, target); };
}

}  // namespace

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
  subject.prepare = prepare;
  return {subject, qVersion()};
}

}  // namespace selvage::reports
