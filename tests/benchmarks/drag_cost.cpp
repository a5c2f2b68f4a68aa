// How long after each move of the mouse the scene is painted with a disc where the mouse drags it, among a
// thousand discs that stand still: with the aim line, the inspector and the table of the window.
#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <algorithm>
#include <fmt/format.h>
#include <vector>

#include "app/lab/lab_window.h"
#include "tests/benchmarks/crowd_window.h"
#include "widgets/scene/camera.h"

using namespace carom;

namespace {

constexpr int kMoves = 200;
constexpr double kNear = 0.02;   // m: bodies snap to round places
constexpr int kPatience = 2000;  // ms

void process(int ms) { QApplication::processEvents(QEventLoop::AllEvents, ms); }

void send(SceneView& view, QEvent::Type type, const QPointF& at, Qt::MouseButton button) {
  const Qt::MouseButtons held = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
  QMouseEvent event(type, at, view.mapToGlobal(at), button, held, Qt::ControlModifier);
  QApplication::sendEvent(&view, &event);
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  apply_theme(application, light_theme());
  LabWindow window(light_theme());
  window.resize(1280, 900);
  window.show();
  Preset preset = bench::thousand_discs();
  preset.scene.bodies = all_bodies(preset.scene);
  preset.scene.generators.clear();
  window.show_scene(preset, {}, {});
  QElapsedTimer clock;
  clock.start();
  while (clock.elapsed() < 1000 || !window.frame() || !window.frame()->scene) process(10);

  SceneView& view = window.scene_view();
  const std::size_t dragged = preset.scene.bodies.size() / 2;
  const Vec2 from = preset.scene.bodies[dragged].position;
  Vec2 wanted = from;
  bool painted_there = false;
  bench::PaintWatch watch(view, [&] {
    const Vec2 at = window.frame()->state.position(static_cast<int>(dragged));
    painted_there = painted_there || (at - wanted).norm() < kNear;
  });
  const auto moved_to = [&](const Vec2& to) {
    wanted = to;
    painted_there = false;
    QElapsedTimer since;
    since.start();
    send(view, QEvent::MouseMove, view.camera().to_screen(to), Qt::NoButton);
    while (since.elapsed() < kPatience && !painted_there) process(1);
    return 1e-6 * static_cast<double>(since.nsecsElapsed());
  };
  send(view, QEvent::MouseButtonPress, view.camera().to_screen(from), Qt::LeftButton);
  const Vec2 begun = from + Vec2(0.5, 0.2);  // farther than a click
  moved_to(begun);
  std::vector<double> waits;  // ms
  for (int move = 1; move <= kMoves; ++move) waits.push_back(moved_to(begun + move * Vec2(0.05, 0.02)));
  send(view, QEvent::MouseButtonRelease, view.camera().to_screen(from + Vec2(10.0, 4.0)), Qt::LeftButton);
  std::sort(waits.begin(), waits.end());
  const auto share = [&](double p) { return waits[static_cast<std::size_t>(p * (kMoves - 1))]; };
  fmt::print("a drag among {} bodies, painted by {}: median {:.1f} ms, p95 {:.1f} ms, longest {:.1f} ms\n",
             preset.scene.bodies.size(), view.uses_opengl() ? "OpenGL" : "QPainter", share(0.5), share(0.95),
             waits.back());
}
