#pragma once

#include <QEvent>
#include <QObject>
#include <functional>
#include <utility>

#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "widgets/scene/scene_view.h"

// What the benchmarks of the window share: a thousand discs, and the pictures that are painted of them.
namespace carom::bench {

inline Body wall(const char* name, double width, double height, const Vec2& position) {
  Body b;
  b.name = name;
  b.shape = Box{width, height};
  b.position = position;
  b.fixed = true;
  return b;
}

inline Preset thousand_discs() {
  Preset s;
  s.title = "A thousand discs";
  s.duration = 1e6;
  s.method.integrator = IntegratorId::kVelocityVerlet;
  s.method.step = 0.01;
  s.scene.bodies = {wall("left", 1.0, 24.0, {-20.5, 0.0}), wall("right", 1.0, 24.0, {20.5, 0.0}),
                    wall("floor", 40.0, 1.0, {0.0, -12.5}), wall("ceiling", 40.0, 1.0, {0.0, 12.5})};
  GridGenerator grid;
  grid.columns = 40;
  grid.rows = 25;
  grid.origin = {-19.0, -11.2};
  grid.spacing = {0.97, 0.93};
  grid.radius_min = grid.radius_max = 0.25;
  grid.speed_max = 1.0;
  s.scene.generators = {grid};
  validate(s);
  return s;
}

// Calls `painted` for each picture that the scene's canvas is about to paint.
class PaintWatch : public QObject {
 public:
  PaintWatch(SceneView& view, std::function<void()> painted) : painted_(std::move(painted)) {
    for (QWidget* child : view.findChildren<QWidget*>()) {
      if (child->size() == view.size()) child->installEventFilter(this);
    }
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Paint) painted_();
    return QObject::eventFilter(watched, event);
  }

 private:
  std::function<void()> painted_;
};

}  // namespace carom::bench
