// Frame rate of the window with six plots and with one, a thousand discs running: scene pictures painted a
// second, alternating in one run. With the lab's own OpenGL or, with CAROM_PAINTER=qpainter, QPainter.
#include <QApplication>
#include <QElapsedTimer>
#include <array>
#include <fmt/format.h>

#include "app/lab/lab_window.h"
#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/validate.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/run/transport_bar.h"
#include "widgets/scene/scene_view.h"

using namespace carom;

namespace {

Body wall(const char* name, double width, double height, const Vec2& position) {
  Body b;
  b.name = name;
  b.shape = Box{width, height};
  b.position = position;
  b.fixed = true;
  return b;
}

Preset thousand_discs() {
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

// Counts the pictures that the scene's canvas paints.
class PaintCounter : public QObject {
 public:
  explicit PaintCounter(SceneView& view) {
    for (QWidget* child : view.findChildren<QWidget*>()) {
      if (child->size() == view.size()) child->installEventFilter(this);
    }
  }
  int painted = 0;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Paint) ++painted;
    return QObject::eventFilter(watched, event);
  }
};

struct Rates {
  double frames = 0.0;  // 1/s
  double speed = 0.0;   // simulated seconds a second
};

Rates measure(LabWindow& window, PaintCounter& counter, int plots) {
  auto* panel = window.findChild<PlotPanel*>();
  constexpr std::array kPlots = {"energy", "momentum", "impulse", "ledger", "drift", "momentum_drift"};
  for (int i = 0; i < static_cast<int>(kPlots.size()); ++i)
    panel->set_shown(kPlots[static_cast<std::size_t>(i)], i < plots);
  const auto run = [](double seconds) {
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < static_cast<qint64>(1e3 * seconds))
      QApplication::processEvents(QEventLoop::AllEvents, 5);
  };
  run(0.5);
  while (window.frame()->rows_known_until < window.frame()->time)
    run(0.1);  // new curves come from the start on
  run(0.5);
  counter.painted = 0;
  const double from = window.frame()->time;
  constexpr double kSeconds = 4.0;
  run(kSeconds);
  return {counter.painted / kSeconds, (window.frame()->time - from) / kSeconds};
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  apply_theme(application, light_theme());
  LabWindow window(light_theme());
  window.resize(1280, 900);
  window.show();
  window.show_scene(thousand_discs(), {}, {});
  emit window.findChild<TransportBar*>()->playClicked(true);
  PaintCounter counter(window.scene_view());
  fmt::print("painted by {}\n", window.scene_view().uses_opengl() ? "OpenGL" : "QPainter");
  Rates sum[2];
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    for (const int plots : {1, 6}) {
      const Rates rates = measure(window, counter, plots);
      sum[plots == 6].frames += rates.frames / kRounds;
      fmt::print("{} plots: {:.1f} pictures a second, x{:.2f}\n", plots, rates.frames, rates.speed);
    }
  }
  fmt::print("six plots beside one: {:.3f} of the frame rate\n", sum[1].frames / sum[0].frames);
}
