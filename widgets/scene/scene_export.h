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

// How pictures of a run show its scene: the part of the world that the camera sees, on its viewport in px.
struct SceneLook {
  Camera camera;
  double side = 4.0;  // m, the shorter side of the view that arrows are scaled for
  DrawingOptions options;
  Theme theme;
  Peaks peaks;  // of the moments that it has shown
};

// The view or, without one, all bodies of the frame, on `pixels`.
[[nodiscard]] SceneLook scene_look(const Frame& frame, const std::optional<View>& view,
                                   const DrawingOptions& options, const Theme& theme, QSize pixels);

// The look of a viewport of another size, that shows no less.
[[nodiscard]] SceneLook on_viewport(SceneLook look, const QSizeF& viewport);

// Paints a moment with the impacts that the frame has, on the look's viewport, and remembers its peaks. Other
// runs of the scene at the same moment are outlines in their colours.
void paint_scene(QPainter& painter, const Frame& frame, SceneLook& look, std::span<const Frame> others = {});

// Saves the scene at one moment as a picture of `pixels`, by the file's suffix: .png, or .svg and .pdf as
// vectors (96 px an inch). Without a view all bodies are shown. Needs no display. The file is replaced only
// when the whole picture is ready; else the answer is false and `error` says why.
[[nodiscard]] bool save_scene_picture(const Frame& frame, const std::optional<View>& view,
                                      const DrawingOptions& options, const Theme& theme, QSize pixels,
                                      const QString& path, QString* error);

// The same into a file that is open already, for its owner to commit. Throws SceneError.
void write_scene_picture(OutputFile& file, const Frame& frame, const std::optional<View>& view,
                         const DrawingOptions& options, const Theme& theme, QSize pixels);

}  // namespace carom
