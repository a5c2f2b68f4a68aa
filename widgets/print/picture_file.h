#pragma once

#include <QSize>
#include <QString>
#include <functional>

class QPainter;

namespace carom {

class OutputFile;

// True for .png, .svg and .pdf: what save_picture() can write.
[[nodiscard]] bool is_picture_name(const QString& path);

// Saves what `paint` paints on an area of `pixels`, by the file's suffix: .png, or .svg and .pdf as vectors
// (96 px an inch). A PNG has `dots` by `dots` image pixels for each of them. Needs no display. The file is
// replaced only when the picture is complete; otherwise returns false with the reason in `error`.
[[nodiscard]] bool save_picture(const QString& path, QSize pixels, const std::function<void(QPainter&)>& paint,
                                QString* error, int dots = 1);

// Writes the same to an open file; the caller commits it. Throws SceneError.
void write_picture(OutputFile& file, QSize pixels, const std::function<void(QPainter&)>& paint, int dots = 1);

}  // namespace carom
