#pragma once

#include <QSize>
#include <QString>
#include <optional>

#include "widgets/drawing.h"

namespace carom {

// Saves the scene at one moment as a picture of `pixels`, by the file's suffix: .png, or .svg and .pdf as
// vectors (96 px an inch). Without a view all bodies are shown. Needs no display. The file is replaced only
// when the whole picture is ready; else the answer is false and `error` says why.
[[nodiscard]] bool save_scene_picture(const Frame& frame, const std::optional<View>& view,
                                      const DrawingOptions& options, const Theme& theme, QSize pixels,
                                      const QString& path, QString* error);

}  // namespace carom
