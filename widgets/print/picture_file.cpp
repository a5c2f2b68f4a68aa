#include "widgets/print/picture_file.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <fmt/format.h>

#include "physics/scene/validate.h"
#include "widgets/print/save_file.h"

namespace carom {
namespace {

using Paint = std::function<void(QPainter&)>;

constexpr int kPixelsPerInch = 96;
constexpr double kPointsPerInch = 72.0;
constexpr int kPdfUnitsPerInch = 1200;

QByteArray png(const Paint& paint, QSize pixels, int dots) {
  QImage image(pixels * dots, QImage::Format_RGB32);
  image.setDevicePixelRatio(dots);
  {
    QPainter painter(&image);
    paint(painter);
  }
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return buffer.data();
}

QByteArray svg(const Paint& paint, QSize pixels) {
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

QByteArray pdf(const Paint& paint, QSize pixels) {
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

QString suffix_of(const QString& path) { return QFileInfo(path).suffix().toLower(); }

}  // namespace

bool is_picture_name(const QString& path) {
  const QString suffix = suffix_of(path);
  return suffix == "png" || suffix == "svg" || suffix == "pdf";
}

void write_picture(OutputFile& file, QSize pixels, const Paint& paint, int dots) {
  if (pixels.isEmpty()) throw SceneError("a picture needs a width and a height above 0");
  const QString name = QString::fromStdString(file.name());
  if (!is_picture_name(name))
    throw SceneError(fmt::format("{}: pictures are saved as .png, .svg or .pdf", file.name()));
  const QString suffix = suffix_of(name);
  const QByteArray bytes = suffix == "png"   ? png(paint, pixels, dots)
                           : suffix == "svg" ? svg(paint, pixels)
                                             : pdf(paint, pixels);
  if (bytes.isEmpty()) throw SceneError(fmt::format("{}: the picture could not be made", file.name()));
  write_bytes(file, bytes);
}

bool save_picture(const QString& path, QSize pixels, const Paint& paint, QString* error, int dots) {
  return save_file(
      path, [&](OutputFile& file) { write_picture(file, pixels, paint, dots); }, error);
}

}  // namespace carom
