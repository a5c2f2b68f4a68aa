// Frame rate of the window with six plots and with one, a thousand discs running: scene pictures painted a
// second, alternating in one run. With the lab's own OpenGL or, with CAROM_PAINTER=qpainter, QPainter.
#include <QApplication>
#include <QElapsedTimer>
#include <array>
#include <fmt/format.h>

#include "app/lab/lab_window.h"
#include "tests/benchmarks/crowd_window.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/run/transport_bar.h"
#include "widgets/scene/scene_view.h"

using namespace carom;

namespace {

struct Rates {
  double frames = 0.0;  // 1/s
  double speed = 0.0;   // simulated seconds a second
};

Rates measure(LabWindow& window, int& painted, int plots) {
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
  painted = 0;
  const double from = window.frame()->time;
  constexpr double kSeconds = 4.0;
  run(kSeconds);
  return {painted / kSeconds, (window.frame()->time - from) / kSeconds};
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  apply_theme(application, light_theme());
  LabWindow window(light_theme());
  window.resize(1280, 900);
  window.show();
  window.show_scene(bench::thousand_discs(), {}, {});
  emit window.findChild<TransportBar*>()->playClicked(true);
  int painted = 0;
  bench::PaintWatch watch(window.scene_view(), [&painted] { ++painted; });
  fmt::print("painted by {}\n", window.scene_view().uses_opengl() ? "OpenGL" : "QPainter");
  Rates sum[2];
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    for (const int plots : {1, 6}) {
      const Rates rates = measure(window, painted, plots);
      sum[plots == 6].frames += rates.frames / kRounds;
      fmt::print("{} plots: {:.1f} pictures a second, x{:.2f}\n", plots, rates.frames, rates.speed);
    }
  }
  fmt::print("six plots beside one: {:.3f} of the frame rate\n", sum[1].frames / sum[0].frames);
}
