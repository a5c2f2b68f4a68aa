#pragma once

#include <QSize>
#include <QString>
#include <optional>
#include <span>

#include "physics/preset/preset.h"
#include "widgets/scene/drawing.h"

class QPainter;

namespace carom {

class OutputFile;

// Options for pictures of a scene: camera with its viewport in px, and drawing options.
struct SceneLook {
  Camera camera;
  double side = 4.0;  // m, the shorter side of the view that arrows are scaled for
  DrawingOptions options;
  Theme theme;
  Peaks peaks;  // of the moments that it has shown
  ArrowTimes times{};
};

// Look with the given view, or fitted to all bodies of the frame, on `pixels`.
[[nodiscard]] SceneLook scene_look(const Frame& frame, const std::optional<View>& view,
                                   const DrawingOptions& options, const Theme& theme, QSize pixels);

// The same look on a viewport of another size; it shows at least as much.
[[nodiscard]] SceneLook on_viewport(SceneLook look, const QSizeF& viewport);

// Paints one frame with its impacts on the look's viewport, and updates the look's peaks. Other runs of the
// scene at the same time are drawn as outlines in their colours.
void paint_scene(QPainter& painter, const Frame& frame, SceneLook& look, std::span<const Frame> others = {});

// Saves the scene at one time as a picture of `pixels`, by the file's suffix: .png, or .svg and .pdf as
// vectors (96 px an inch). Without a view all bodies are shown. Needs no display. The file is replaced only
// when the whole picture is ready; otherwise returns false with the reason in `error`.
[[nodiscard]] bool save_scene_picture(const Frame& frame, const std::optional<View>& view,
                                      const DrawingOptions& options, const Theme& theme, QSize pixels,
                                      const QString& path, QString* error);

// Writes the same to an open file; the caller commits it. Throws SceneError.
void write_scene_picture(OutputFile& file, const Frame& frame, const std::optional<View>& view,
                         const DrawingOptions& options, const Theme& theme, QSize pixels);

}  // namespace carom
