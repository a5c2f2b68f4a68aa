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
// (96 px an inch). A PNG has `dots` by `dots` points for a pixel. Needs no display. The file is replaced only
// when the whole picture is ready; else the answer is false and `error` says why.
[[nodiscard]] bool save_picture(const QString& path, QSize pixels, const std::function<void(QPainter&)>& paint,
                                QString* error, int dots = 1);

// The same into a file that is open already, for its owner to commit. Throws SceneError.
void write_picture(OutputFile& file, QSize pixels, const std::function<void(QPainter&)>& paint, int dots = 1);

}  // namespace carom
