#include "widgets/scene_export.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <QSvgGenerator>
#include <algorithm>

#include "widgets/paint_drawing.h"

namespace carom {
namespace {

constexpr int kPixelsPerInch = 96;
constexpr double kPointsPerInch = 72.0;
constexpr int kPdfUnitsPerInch = 1200;
constexpr int kMargin = 40;  // px about a fitted scene

QByteArray png(const auto& paint, QSize pixels) {
  QImage image(pixels, QImage::Format_RGB32);
  {
    QPainter painter(&image);
    paint(painter);
  }
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return buffer.data();
}

QByteArray svg(const auto& paint, QSize pixels) {
  QBuffer buffer;
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setResolution(kPixelsPerInch);
  generator.setSize(pixels);
  generator.setViewBox(QRect(QPoint(), pixels));
  generator.setTitle("Carom");
  QPainter painter(&generator);
  paint(painter);
  painter.end();
  return buffer.data();
}

QByteArray pdf(const auto& paint, QSize pixels) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&buffer);
    writer.setTitle("Carom");
    writer.setResolution(kPdfUnitsPerInch);
    writer.setPageSize(QPageSize(QSizeF(pixels) * kPointsPerInch / kPixelsPerInch, QPageSize::Point, {},
                                 QPageSize::ExactMatch));
    writer.setPageMargins({});
    QPainter painter(&writer);
    painter.scale(double(kPdfUnitsPerInch) / kPixelsPerInch, double(kPdfUnitsPerInch) / kPixelsPerInch);
    paint(painter);
  }
  return buffer.data();
}

}  // namespace

bool save_scene_picture(const Frame& frame, const std::optional<View>& view, const DrawingOptions& options,
                        const Theme& theme, QSize pixels, const QString& path, QString* error) {
  const auto fail = [error](const QString& why) {
    if (error != nullptr) *error = why;
    return false;
  };
  if (pixels.isEmpty()) return fail("a picture needs a width and a height above 0");

  Camera camera;
  camera.viewport = pixels;
  if (view) {
    camera.show(*view);
  } else {
    camera.fit(bounds(frame), QMarginsF(kMargin, kMargin, kMargin, kMargin));
  }
  Peaks peaks;
  peaks.observe(frame);
  const double side = std::min(pixels.width(), pixels.height()) / camera.scale;
  const Drawing drawing =
      make_drawing({frame, frame.impacts, camera, options, theme, arrow_scale(peaks, side)});
  const auto paint = [&](QPainter& painter) { paint_drawing(painter, drawing, camera, theme); };

  const QString suffix = QFileInfo(path).suffix().toLower();
  QByteArray bytes;
  if (suffix == "png") {
    bytes = png(paint, pixels);
  } else if (suffix == "svg") {
    bytes = svg(paint, pixels);
  } else if (suffix == "pdf") {
    bytes = pdf(paint, pixels);
  } else {
    return fail(QString("%1: pictures are saved as .png, .svg or .pdf").arg(path));
  }
  if (bytes.isEmpty()) return fail(QString("%1: the picture could not be made").arg(path));

  QSaveFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit()) {
    return fail(QString("%1: %2").arg(path, file.errorString()));
  }
  return true;
}

}  // namespace carom
